"""The table of mutants fits the sources: every fragment is found, once, and no name stands for two."""
import sys
import unittest

import mutants


def one(at, old, new):
    return mutants.Mutant("room", "file", at, old, new, ())


class Table(unittest.TestCase):
    def test_fits_the_sources(self):
        everything = mutants.read_all()
        for name, there in mutants.by_file(everything).items():
            mutants.with_mutants((mutants.top / name).read_text(), there)
        self.assertEqual(len({m.name for m in everything}), len(everything))
        for m in everything:
            self.assertNotEqual(m.old, m.new, m)


class Switch(unittest.TestCase):
    def test_of_an_expression_and_of_a_statement(self):
        text = "constexpr double k = 3;\nadd(s, d);\n"
        a, b = one("k = 3", "3", "4"), one("add(s, d);", "add(s, d);", "")
        out = mutants.with_mutants(text, [a, b])
        self.assertIn(f"const double k = ({mutants.chosen(a)} ? (4) : (3));\n", out)
        self.assertNotIn("constexpr", out)
        self.assertIn(f"{{ if ({mutants.chosen(b)}) {{  }} else {{ add(s, d); }} }}\n", out)

    def test_of_two_mutants_of_one_fragment(self):
        a, b = one("a < b", "a < b", "a <= b"), one("a < b", "a < b", "a > b")
        self.assertEqual(mutants.switched("a < b", [a, b]),
                         f"({mutants.chosen(a)} ? (a <= b) : {mutants.chosen(b)} ? (a > b) : (a < b))")

    def test_refuses_what_is_not_there_once(self):
        for text, m in (("x = 3; y = 3;", one("3", "3", "4")), ("x = 3;", one("y = 3", "3", "4")),
                        ("a + b + c", one("a + b + c", "+", "-"))):
            self.assertRaises(mutants.TableError, mutants.span, m, text)
        crossing = [one("a + b", "a + b", "a"), one("b + c", "b + c", "c")]
        self.assertRaises(mutants.TableError, mutants.with_mutants, "a + b + c", crossing)


if __name__ == "__main__":
    sys.exit(unittest.main())
