#!/usr/bin/env python3
"""Labels of a scan, as segmentation programs write them, become an organ with vessels and tumour.

    scan_test.py PROGRAM FOLDER
"""
import gzip
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import unittest
from pathlib import Path

PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2])
LIMIT = 300 * float(os.environ.get("RESECT_PATIENCE", 1))  # s for one run; a sanitized program is slower
DIMS, STEP, ORIGIN = (60, 50, 38), (3.0, 3.0, 4.0), (40.0, -20.0, 300.0)  # mm, right-anterior-superior
NAMES = ("liver", "liver_tumor", "liver_vessels", "spleen", "liver_cyst")


def resect(*args):
    return subprocess.run([PROGRAM, *map(str, args)], capture_output=True, text=True, timeout=LIMIT)


def near(p, a, b, radius):
    """Whether a point lies in a tube from a to b."""
    d = [b[i] - a[i] for i in range(3)]
    t = sum((p[i] - a[i]) * d[i] for i in range(3)) / sum(x * x for x in d)
    t = min(1, max(0, t))
    return math.dist(p, [a[i] + t * d[i] for i in range(3)]) < radius


def structures(p):
    """Which structures are at a place, in mm from the middle of the image."""
    x, y, z = p
    liver = (x / 80) ** 2 + (y / 60) ** 2 + (z / 55) ** 2 < 1
    return {"liver": liver, "liver_tumor": math.dist(p, (30, -10, 10)) < 14,
            "liver_vessels": near(p, (-10, 0, -75), (0, 0, 0), 7) or near(p, (0, 0, 0), (55, 10, 5), 6),
            "spleen": math.dist(p, (-72, 55, 40)) < 12, "liver_cyst": False}


def made():
    """Voxels of each structure, first axis fastest."""
    voxels = {name: bytearray() for name in NAMES}
    middle = [DIMS[a] * STEP[a] / 2 for a in range(3)]
    for k in range(DIMS[2]):
        for j in range(DIMS[1]):
            for i in range(DIMS[0]):
                there = structures([(n + 0.5) * STEP[a] - middle[a] for a, n in enumerate((i, j, k))])
                for name in NAMES:
                    voxels[name].append(there[name])
    return voxels


def nifti(data):
    """The bytes of a NIfTI-1 file of 8 bits with the axes of the patient."""
    h = struct.pack("<i36x8h", 348, 3, *DIMS, 1, 1, 1, 1) + struct.pack("<14x2hh", 2, 8, 0)
    h += struct.pack("<8f", 1, *STEP, 1, 1, 1, 1) + struct.pack("<3f", 352, 0, 0) + struct.pack("<h2b", 0, 0, 2)
    h = h.ljust(252, b"\0") + struct.pack("<2h6f", 0, 1, *[0] * 6)
    for a in range(3):
        h += struct.pack("<4f", *[STEP[a] if b == a else 0 for b in range(3)], ORIGIN[a])
    return h.ljust(344, b"\0") + b"n+1\0" + b"\0" * 4 + bytes(data)


def write(name, data):
    path = FOLDER / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(gzip.compress(data, mtime=0) if name.endswith(".gz") else data)
    return path


class Scan(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        cls.voxels = made()
        cls.ml = {name: sum(v) * math.prod(STEP) / 1000 for name, v in cls.voxels.items()}
        for name in NAMES:
            write(f"patient/{name}.nii.gz", nifti(cls.voxels[name]))
        cls.patient = FOLDER / "patient"
        both = bytes(2 if t else 3 if v else 1 if liver else 0 for liver, t, v in
                     zip(*(cls.voxels[name] for name in NAMES[:3])))
        cls.labels = write("labels.nii", nifti(both))

    def test_a_folder_of_labels_becomes_an_operation_in_one_command(self):
        done = resect("run", "cut-120", "--organ", self.patient, "--spacing", "6mm", "--json", FOLDER / "run.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"the organ is liver {self.ml['liver']:.4g} ml, with liver_tumor {self.ml['liver_tumor']:.4g} ml "
                      "(tumour), liver_vessels", done.stdout)
        self.assertIn("liver_cyst.nii.gz: nothing is labelled in it; it was left out", done.stdout)
        run = json.loads((FOLDER / "run.json").read_text())
        self.assertAlmostEqual(run["organ_ml"], self.ml["liver"], delta=0.005 * self.ml["liver"])

    def test_the_organ_is_made_once_with_labels_vessels_and_where_it_comes_from(self):
        cells = FOLDER / "patient.resect-cells"
        done = resect("organ", self.patient, "--spacing", "5mm", "-o", cells, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        about = json.loads(resect("info", cells, "--json").stdout)
        self.assertEqual(about["inputs"], json.loads(done.stdout)["inputs"])
        self.assertEqual([(one["file"], one["role"]) for one in about["inputs"]],
                         [("liver.nii.gz", "organ"), ("liver_tumor.nii.gz", "tumour"),
                          ("liver_vessels.nii.gz", "portal-vein")])
        self.assertIn("60 x 50 x 38 voxels of 3 x 3 x 4 mm, axes RAS", about["inputs"][0]["format"])
        self.assertEqual([one["name"] for one in about["labels"]], ["parenchyma", "liver_tumor"])
        self.assertGreater(about["vessels"]["portal-vein"], 3)
        self.assertAlmostEqual(about["volume_ml"], self.ml["liver"], delta=0.005 * self.ml["liver"])
        # In the room x leads to the patient's left, y to the front, z to the feet.
        middle = [(about["bounds_m"][0][a] + about["bounds_m"][1][a]) / 2 for a in range(3)]
        right, front, head = [(ORIGIN[a] + (DIMS[a] - 1) * STEP[a] / 2) / 1000 for a in range(3)]
        wanted = [-right, front, -head]
        for a in range(3):
            self.assertAlmostEqual(middle[a], wanted[a], delta=0.005)
        again = FOLDER / "again.resect-cells"
        self.assertEqual(resect("organ", self.patient, "--spacing", "5mm", "-o", again).returncode, 0)
        self.assertEqual(cells.read_bytes(), again.read_bytes())
        done = resect("run", "cut-120", "--organ", cells)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_an_image_of_several_labels_needs_to_know_the_organ_and_takes_roles(self):
        done = resect("run", "cut-120", "--organ", self.labels)
        self.assertEqual(done.returncode, 1)
        self.assertIn("holds 3 labels; choose the organ with --part: label 1, label 2, label 3", done.stderr)
        cells = FOLDER / "roles.resect-cells"
        done = resect("organ", self.labels, "--label", "1", "--structure", "tumour=2", "--structure",
                      "portal-vein=3", "--spacing", "5mm", "-o", cells, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        about = json.loads(done.stdout)
        # The trunk outside the organ is a vessel and no tissue.
        self.assertAlmostEqual(about["volume_ml"], self.ml["liver"], delta=0.01 * self.ml["liver"])
        self.assertEqual([one["name"] for one in about["labels"]], ["parenchyma", "tumour"])
        about = json.loads(resect("info", self.labels, "--json").stdout)
        self.assertEqual([(one["value"], one["name"]) for one in about["labels"]], [(1, ""), (2, ""), (3, "")])
        self.assertIn("choose the organ", about["refusal"])
        for wrong, what in ((["--structure", "kidney=2"], "kinds are tumour"),
                            (["--structure", "tumour=9"], "has no label '9'; it has: 1, 2, 3"),
                            (["--unit", "mm"], "leave --unit out")):
            done = resect("organ", self.labels, "--label", "1", *wrong, "-o", FOLDER / "no.resect-cells")
            self.assertIn(done.returncode, (1, 2))
            self.assertIn(what, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
        self.assertFalse((FOLDER / "no.resect-cells").exists())

    def test_another_organ_of_the_folder_and_models_beside_images_are_taken(self):
        done = resect("run", "cut-120", "--organ", self.patient, "--label", "spleen", "--spacing", "3mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"the organ is spleen {self.ml['spleen']:.4g} ml", done.stdout)
        done = resect("run", "cut-120", "--organ", self.patient, "--label", "kidney")
        self.assertIn("is named 'kidney'; choose the organ with --part: liver, liver_cyst", done.stderr)
        liver, tumour = FOLDER / "liver.stl", FOLDER / "tumour.stl"
        for label, out in ((self.patient / "liver.nii.gz", liver), (self.patient / "liver_tumor.nii.gz", tumour)):
            self.assertEqual(resect("convert", label, out).returncode, 0)
        cells = FOLDER / "models.resect-cells"
        done = resect("organ", liver, tumour, "-o", cells, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        about = json.loads(done.stdout)
        self.assertEqual([one["name"] for one in about["labels"]], ["parenchyma", "tumour"])
        self.assertAlmostEqual(about["volume_ml"], self.ml["liver"], delta=0.005 * self.ml["liver"])

    def test_a_folder_that_names_no_organ_asks_for_it_and_says_what_is_empty(self):
        names = {"Leber": "liver", "Tumor_1": "liver_tumor", "Pfortader": "liver_vessels", "leer": "liver_cyst"}
        for name, structure in names.items():
            write(f"german/{name}.nii.gz", nifti(self.voxels[structure]))
        german = FOLDER / "german"
        for args, sentence in (
                ((), "none of 4 files is named as an organ is; choose the organ with --part: "),
                (("--label", "leer"), "leer.nii.gz: nothing is labelled in it; choose another organ with --part: "),
                (("--label", "Leber", "--label", "Tumor_1"), "of several files one is the organ; give only one --part"),
                (("--label", "Leber", "--structure", "tumour=Tumor_1", "--structure", "cyst=Tumor_1"),
                 "is given two roles, tumour and cyst; leave one out")):
            done = resect("run", "cut-120", "--organ", german, *args)
            self.assertIn(done.returncode, (1, 2), args)
            self.assertIn(sentence, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        done = resect("run", "cut-120", "--organ", german, "--label", "Leber", "--structure", "tumour=Tumor_1",
                      "--spacing", "6mm")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\n +labels +.*Tumor_1: |\n +Tumor_1: ")

    def test_what_is_no_label_image_is_refused_with_what_to_do(self):
        empty = FOLDER / "nothing"
        empty.mkdir(parents=True, exist_ok=True)
        scan = bytearray(nifti(self.voxels["liver"]))
        for i in range(352, len(scan)):
            scan[i] = i * 37 % 200 + 1
        for path, what in ((empty, "is a folder without label images"),
                           (write("scan.nii.gz", bytes(scan)), "is a scan and not its labels"),
                           (write("torn.nii", nifti(self.voxels["liver"])[:-100]), "ends early"),
                           (write("empty.nii", nifti(bytes(len(self.voxels["liver"])))), "nothing is labelled in it")):
            for command in (["info", path], ["organ", path, "-o", FOLDER / "no.resect-cells"],
                            ["run", "cut-120", "--organ", path]):
                done = resect(*command)
                if command[0] != "info":
                    self.assertEqual(done.returncode, 1, command)
                    self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertIn(what, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
