"""The check of equations finds what it looks for."""

import unittest

import equations

PAGE = "text\n```\n(1)   a = b\n(2)   c\n(2a)  d\n```\n| 1 | strain | (3) e | key |\nas in (1) and (9)\n(8) is prose\n"
ALL = f"// {equations.PAGE} (eqs. 1 to 3)."


class Faults(unittest.TestCase):
    def faults(self, page=PAGE, **sources):
        return list(equations.faults(page, sources))

    def test_none(self):
        self.assertEqual(self.faults(a=ALL), [])
        two = f"// {equations.PAGE} (eq. 1), (eqs. 2\n    // and 2a)"
        self.assertEqual(self.faults(a=two, b=f"// {equations.PAGE} (eq. 3)", c="f(4); // eq. 10 of the paper"), [])

    def test_of_a_page(self):
        self.assertEqual(self.faults(PAGE + "```\n(4) f\n```\n", a=ALL), [f"{equations.PAGE}: no code cites (4)"])
        self.assertEqual(self.faults(PAGE + "| 7 | (1) f |\n", a=ALL), [f"{equations.PAGE}: (1) stands twice"])

    def test_of_a_file(self):
        self.assertEqual(self.faults(a=ALL + "(eq. 4)"), [f"a: no equation (4) in {equations.PAGE}"])
        self.assertEqual(self.faults(a=ALL, b="// (eq. 1)"),
                         [f"b: cites equations, but does not name {equations.PAGE}"])


if __name__ == "__main__":
    unittest.main()
