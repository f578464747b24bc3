"""Function definitions of a C++ file and their lengths, by braces alone: enough for this code's clang-format.

A definition stands at namespace or class level; a lambda belongs to the function around it. Its length is the number of
lines from its first line (template line and return type included) to its closing brace.
"""

import re

BLANKED = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\''
                     r"|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.DOTALL | re.MULTILINE)
TEMPLATE = re.compile(r"^\s*template\s*<")
OPERATOR = re.compile(r"\boperator\s*(?:\(\)|[^\s\w(]+)")
NAME = re.compile(r"((?:[\w:~]|<[^<>]*>)+)\s*$")


def blanked(text):
    """The text without comments, literals and preprocessor lines; every newline and column stays."""
    return BLANKED.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)


def closing(text, opened, pair="{}"):
    """Position of the bracket that closes the one at `opened`."""
    depth = 0
    for position in range(opened, len(text)):
        depth += (text[position] == pair[0]) - (text[position] == pair[1])
        if depth == 0:
            return position
    return len(text) - 1


def without_templates(head):
    while TEMPLATE.match(head):
        head = head[closing(head, head.index("<"), "<>") + 1:]
    return head


def outside_parentheses(head):
    """What of a statement's head stands outside ( ), which are kept as a bare pair."""
    kept, depth = [], 0
    for letter in head:
        depth -= letter == ")"
        if depth == 0:
            kept.append(letter)
        depth += letter == "("
    return "".join(kept)


def kind_of(head):
    """What the brace after `head` opens: "scope" (to look into), "function", "member" (an initializer of a
    constructor's list, after which its head goes on) or "other"."""
    bare = outside_parentheses(OPERATOR.sub("operator", without_templates(head)))
    if re.match(r"\s*(?:inline\s+)?namespace\b|\s*extern\s*$", bare):
        return "scope"
    if re.match(r"\s*(?:typedef\s+)?(?:class|struct|union)\b(?!.*\)\s*(?:const|noexcept|override|\s)*$)", bare, re.DOTALL):
        return "scope"
    if "(" not in bare or "=" in bare or re.match(r"\s*enum\b", bare):
        return "other"
    if re.search(r"\)[^():]*(?<!:):(?!:)", bare) and re.search(r"[\w>]\s*$", bare):
        return "member"
    return "function"


def name_of(head):
    bare = OPERATOR.sub(lambda found: "operator", without_templates(head))
    found = NAME.search(bare[:bare.index("(")])
    return found.group(1) if found else bare.strip()


def functions(text):
    """(name, first line, number of lines) of every function defined in the text."""
    code = blanked(text)
    start = position = 0
    while position < len(code):
        letter = code[position]
        if letter == "(":
            position = closing(code, position, "()")
        elif letter in ";}":
            start = position + 1
        elif letter == "{":
            head, kind = code[start:position], kind_of(code[start:position])
            if kind == "scope":
                start = position + 1
            else:
                end = closing(code, position)
                if kind == "function":
                    first = start + len(head) - len(head.lstrip())
                    yield name_of(head), code.count("\n", 0, first) + 1, code.count("\n", first, end) + 1
                position = end
                start = start if kind == "member" else end + 1
        elif letter == ":" and re.search(r"\b(?:public|private|protected)\s*$", code[start:position]):
            start = position + 1
        position += 1
