#!/usr/bin/env python3
"""The layering check must see each kind of breach, and nothing in a clean tree."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.dont_write_bytecode = True
import cpp_functions  # noqa: E402
import layering  # noqa: E402


def function(name, lines):
    """Text of a function of that many lines."""
    return f"void {name}() {{\n" + "    work();\n" * (lines - 2) + "}\n"


class Layering(unittest.TestCase):
    def breaches(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return list(layering.breaches(root))

    def test_accepts_arrows_of_the_architecture(self):
        self.assertEqual(self.breaches({"engine/dem/a.hpp": '#include "base/error.hpp"\n#include "dem/b.hpp"\n',
                                        "engine/graph/a.cpp": "tbb::flow::graph g;\n"}), [])

    def test_refuses_an_arrow_against_the_table(self):
        self.assertIn("engine/mpm/a.hpp:2: mpm must not include dem/packing.hpp",
                      self.breaches({"engine/mpm/a.hpp": '#pragma once\n#include "dem/packing.hpp"\n'}))

    def test_refuses_task_graphs_outside_graph(self):
        self.assertEqual(len(self.breaches({"engine/mpm/a.cpp": "tbb::flow::graph g;\n"})), 1)

    def test_refuses_mpi_outside_its_room(self):
        self.assertEqual(self.breaches({"engine/ranks/a.cpp": "#include <mpi.h>\nint r = MPI_Send(x);\n",
                                        "engine/mpi/a.cpp": "#include <mpi.h>\n// MPI_Send\n"}),
                         ["engine/ranks/a.cpp:1: only engine/mpi may name #include <mpi.h>",
                          "engine/ranks/a.cpp:2: only engine/mpi may name MPI_Send"])

    def test_refuses_libtorch_in_engine(self):
        self.assertEqual(len(self.breaches({"engine/app/a.cpp": "#include <torch/torch.h>\n"})), 1)

    def test_refuses_long_files_and_unknown_folders(self):
        self.assertEqual(len(self.breaches({"engine/base/a.cpp": "\n" * 401, "misc/a.py": ""})), 2)

    def test_accepts_results_of_runs_in_the_checkout(self):
        self.assertEqual(self.breaches({"results/run/load.csv": "d_over_B,load\n"}), [])

    def test_refuses_a_circle_of_modules_through_a_source(self):
        self.assertEqual(self.breaches({"engine/dem/a.hpp": '#include "dem/b.hpp"\n', "engine/dem/b.hpp": "",
                                        "engine/dem/b.cpp": '#include "dem/b.hpp"\n#include "dem/c.hpp"\n',
                                        "engine/dem/c-inl.hpp": '#include "dem/a.hpp"\n', "engine/dem/c.hpp": ""}),
                         ["circle of modules: engine/dem/a -> engine/dem/b -> engine/dem/c -> engine/dem/a"])

    def test_refuses_a_circle_of_modules_beside_engine(self):
        self.assertEqual(len(self.breaches({"training/a.hpp": '#include "training/b.hpp"\n',
                                            "training/b.hpp": '#include "training/a.hpp"\n'})), 1)

    def test_accepts_modules_of_one_name_in_two_folders(self):
        self.assertEqual(self.breaches({"engine/dem/check.hpp": "", "engine/io/check.cpp": '#include "dem/check.hpp"\n',
                                        "engine/io/check.hpp": ""}), [])

    def test_refuses_a_long_function(self):
        self.assertEqual(self.breaches({"surrogate/a.cpp": function("long_one", 41), "engine/dem/a.cpp": "int a;\n"}),
                         ["surrogate/a.cpp:1: long_one has 41 lines, more than 40"])

    def test_refuses_functions_that_are_long_on_the_whole(self):
        many = "".join(function(f"f{i}", 8) for i in range(9)) + function("g", 20) + function("h", 20)
        self.assertEqual(self.breaches({"engine/dem/a.cpp": many}),
                         ["engine/: the median of function lengths is 8 lines, to be below 8",
                          "engine/: the 90th percentile of function lengths is 20 lines, to be below 20"])

    def test_refuses_prints_in_engine_outside_app_and_console(self):
        printing = 'void f() { fmt::print("x"); }\nvoid g() { std::cerr << 1; }\nvoid h() { printf("x"); }\n'
        self.assertEqual([breach.split(": ")[0] for breach in self.breaches({"engine/io/a.cpp": printing})],
                         ["engine/io/a.cpp:1", "engine/io/a.cpp:2", "engine/io/a.cpp:3"])
        self.assertEqual(self.breaches({"engine/app/a.cpp": printing, "engine/base/console.cpp": printing,
                                        "engine/io/a.cpp": 'void f() { std::snprintf(b, 3, "x"); }  // std::cout\n'}), [])

    def test_finds_a_circle(self):
        self.assertEqual(layering.circle({"a": {"b"}, "b": {"c"}, "c": {"a"}}), ["a", "b", "c", "a"])
        self.assertIsNone(layering.circle(layering.ARROWS))

    def test_the_table_of_folders_is_what_is_checked(self):
        arrows = dict(layering.ARROWS)
        try:
            layering.ARROWS["base"] = {"app"}
            self.assertEqual([breach[:36] for breach in self.breaches({})], ["circle in the table of arrows: app -"])
        finally:
            layering.ARROWS.clear()
            layering.ARROWS.update(arrows)


class Functions(unittest.TestCase):
    def found(self, text):
        return list(cpp_functions.functions(text))

    def test_functions_of_namespaces_and_classes(self):
        self.assertEqual(self.found("""namespace a {
class B : public C {
  public:
    B() : x_{1}, y_(2) {
        work();
    }
    int x() const { return x_; }
    B& operator=(const B&) {
        return *this;
    }
};
template <class T = int>
void A<T>::f(int x = 3,
             int y) noexcept {
    for (;;) {
    }
}
}
"""), [("B", 4, 3), ("x", 7, 1), ("operator", 8, 3), ("A<T>::f", 12, 6)])

    def test_lambdas_initializers_and_text_are_none(self):
        self.assertEqual(self.found("""enum class E { a, b };
struct P { int a = 0; std::array<int, 2> b{1, 2}; };
const auto square = [](int x) { return x * x; };
constexpr Row rows[] = {{1, f(2)}, {3, 4}};
#define BODY(x) void x() { }
// void g() { }
const char* text = "void h() { }";
int real() {
    return std::count_if(a, b, [](char c) {
        return c == '{' || c == '"';
    });
}
"""), [("real", 8, 5)])


if __name__ == "__main__":
    unittest.main()
