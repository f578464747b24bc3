#!/usr/bin/env python3
"""The layering check must see each kind of breach, and nothing in a clean tree."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.dont_write_bytecode = True
import layering  # noqa: E402


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

    def test_refuses_libtorch_in_engine(self):
        self.assertEqual(len(self.breaches({"engine/app/a.cpp": "#include <torch/torch.h>\n"})), 1)

    def test_refuses_long_files_and_unknown_folders(self):
        self.assertEqual(len(self.breaches({"engine/base/a.cpp": "\n" * 401, "misc/a.py": ""})), 2)

    def test_accepts_results_of_runs_in_the_checkout(self):
        self.assertEqual(self.breaches({"results/run/load.csv": "d_over_B,load\n"}), [])

    def test_finds_a_circle(self):
        self.assertEqual(layering.circle({"a": {"b"}, "b": {"c"}, "c": {"a"}}), ["a", "b", "c", "a"])
        self.assertIsNone(layering.circle(layering.ARROWS))


if __name__ == "__main__":
    unittest.main()
