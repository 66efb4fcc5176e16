"""The checks of tools/: each rule is broken once in a small tree."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[2] / "tools"
LAYERS = "base:\ngeometry: base\ninventor: base geometry\napp: base geometry inventor\n"
HEADER = "// What is this?\n#pragma once\n"


class Tree(unittest.TestCase):
    def check(self, script, files, layers=LAYERS, rules=""):
        """Exit status and output of the check on a tree of these files."""
        files = {"tools/layers.txt": layers, "tools/file_rules.txt": rules,
                 "src/base/vec.h": HEADER, **files}
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                if text is None:
                    continue
                path = Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            done = subprocess.run([sys.executable, "-B", TOOLS / script, folder],
                                  capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def refused(self, script, files, expected, **more):
        status, output = self.check(script, files, **more)
        self.assertEqual(status, 1, output)
        self.assertIn(expected, output)


class Layers(Tree):
    def test_includes_that_point_downwards_are_fine(self):
        status, output = self.check("check_layers.py", {
            "src/geometry/box.h": HEADER + '#include <vector>\n#include "base/vec.h"\n',
            "src/inventor/view.cpp": '#include <Inventor/SbColor.h>\n#include "geometry/box.h"\n'})
        self.assertEqual(status, 0, output)

    def test_an_include_of_a_higher_layer_is_refused_with_its_line(self):
        self.refused("check_layers.py", {
            "src/geometry/box.h": HEADER,
            "src/base/vec.cpp": '#include "base/vec.h"\n\n#include "geometry/box.h"\n'},
            "src/base/vec.cpp:3: base may not include geometry")

    def test_coin_and_qt_are_refused_outside_their_layers(self):
        self.refused("check_layers.py", {"src/geometry/a.cpp": "#include <Inventor/SoDB.h>\n"},
                     "src/geometry/a.cpp:1: <Inventor/SoDB.h> belongs to app and inventor")
        self.refused("check_layers.py", {"src/inventor/a.cpp": "#include <QWidget>\n"},
                     "src/inventor/a.cpp:1: <QWidget> belongs to app only")

    def test_a_star_means_the_layers_above_it_in_the_list_and_no_more(self):
        layers = "base:\ngeometry: *\ninventor: *\n"
        status, output = self.check("check_layers.py", {
            "src/geometry/a.cpp": '#include "base/vec.h"\n'}, layers=layers)
        self.assertEqual(status, 0, output)
        self.refused("check_layers.py", {
            "src/inventor/view.h": HEADER, "src/geometry/a.cpp": '#include "inventor/view.h"\n'},
            "geometry may not include inventor", layers=layers)

    def test_an_include_without_a_layer_or_of_no_file_is_refused(self):
        self.refused("check_layers.py", {"src/base/a.cpp": '#include "vec.h"\n'}, "a.cpp:1:")
        self.refused("check_layers.py", {"src/base/a.cpp": '#include "base/no.h"\n'}, "a.cpp:1:")

    def test_a_folder_that_is_no_layer_is_refused(self):
        self.refused("check_layers.py", {"src/extra/a.cpp": "\n"}, "extra is no layer")

    def test_a_file_in_a_sub_folder_belongs_to_the_layer(self):
        files = {"src/geometry/flat/box.h": HEADER,
                 "src/inventor/view.cpp": '#include "geometry/flat/box.h"\n'}
        status, output = self.check("check_layers.py", files)
        self.assertEqual(status, 0, output)
        self.refused("check_layers.py", {**files, "src/base/deep/a.cpp": '#include "geometry/flat/box.h"\n'},
                     "src/base/deep/a.cpp:1: base may not include geometry")

    def test_a_list_of_layers_with_a_cycle_is_refused(self):
        self.refused("check_layers.py", {}, "layers.txt:1:", layers="base: geometry\ngeometry: base\n")


class Files(Tree):
    def test_a_tree_that_keeps_the_rules_is_fine(self):
        status, output = self.check("check_files.py", {"src/base/a.cpp": "int a;\n" * 400})
        self.assertEqual(status, 0, output)

    def test_a_long_file_is_refused_unless_it_is_listed_with_a_reason(self):
        long = {"src/base/a.cpp": "int a;\n" * 401}
        self.refused("check_files.py", long, "src/base/a.cpp:401: 401 lines")
        status, output = self.check("check_files.py", long, rules="src/base/a.cpp: a table\n")
        self.assertEqual(status, 0, output)
        self.refused("check_files.py", long, "file_rules.txt:1", rules="src/base/a.cpp\n")

    def test_a_folder_of_many_files_is_refused_unless_it_is_listed_with_a_reason(self):
        many = {f"data/a{number}.txt": "" for number in range(26)}
        self.refused("check_files.py", many, "data:1: 26 files, more than 25")
        status, output = self.check("check_files.py", many, rules="data: one file for each of something\n")
        self.assertEqual(status, 0, output)
        status, output = self.check("check_files.py", {**many, "data/a0.txt": None, "data/b/a0.txt": ""})
        self.assertEqual(status, 0, output)

    def test_an_exception_for_a_file_that_is_gone_is_refused(self):
        self.refused("check_files.py", {}, "there is no src/base/b.cpp", rules="src/base/b.cpp: why\n")

    def test_a_name_that_says_nothing_is_refused(self):
        self.refused("check_files.py", {"src/base/mesh_utils.cpp": "\n"}, '"utils" in a name')

    def test_a_header_without_its_comment_or_guard_is_refused(self):
        self.refused("check_files.py", {"src/base/a.h": "#pragma once\n"}, "src/base/a.h:1:")
        self.refused("check_files.py", {"src/base/a.h": "// What?\n"}, "#pragma once is missing")

    def test_a_link_that_leads_nowhere_is_refused(self):
        files = {"docs/a.md": "see\n[there](b.md) and [that](https://example.org/x)\n"}
        self.refused("check_files.py", files, "docs/a.md:2: the link to b.md leads nowhere")
        status, output = self.check("check_files.py", {**files, "docs/b.md": "# B\n"})
        self.assertEqual(status, 0, output)

    def test_a_function_that_differs_between_machines_is_refused_below_the_pictures(self):
        self.refused("check_files.py", {"src/base/a.cpp": "\ndouble a = std::sin(1);\n"}, "src/base/a.cpp:2: std::sin")
        self.refused("check_files.py", {"src/base/a.cpp": "Eigen::AngleAxisd a;\n"}, "a.cpp:1: AngleAxis")
        status, output = self.check("check_files.py", {"src/inventor/a.cpp": "double a = std::sin(1);\n"})
        self.assertEqual(status, 0, output)

    def test_a_path_of_one_machine_is_refused(self):
        place = "/".join(["", "home", "somebody", "x"])
        self.refused("check_files.py", {"docs/a.md": "\nsee " + place + "\n"}, "docs/a.md:2:")


if __name__ == "__main__":
    unittest.main()
