"""tools/translations.py: what it takes for a text, and what it says about a translation."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import translations


class Translations(unittest.TestCase):
    def test_neighbouring_literals_are_one_text_and_comments_are_none(self):
        code = '#include "a.h"\n// "not this"\nsay("one "\n    "text", \'"\', "with \\"marks\\"");\n'
        self.assertEqual([text for _, text in translations.literals(code)], ["one text", 'with "marks"'])

    def test_figures_become_numbered_values(self):
        self.assertEqual(translations.numbered(" {} of {:.1f} mm"), "%1 of %2 mm")

    def test_a_translation_is_finished_and_keeps_values_keys_and_points(self):
        fault = translations.faults_of
        self.assertEqual(fault("window", "&Save %1 ...", "%1 &sichern ...", True), "")
        self.assertIn("no finished translation", fault("window", "Save", "Sichern", False))
        self.assertIn("no finished translation", fault("window", "Save", "", True))
        self.assertIn("placeholders", fault("sentences", "%1 of %2", "%1 von", True))
        self.assertIn("a key after &", fault("window", "&Save", "Sichern", True))
        self.assertIn("three points", fault("window", "Save ...", "Sichern", True))


if __name__ == "__main__":
    unittest.main()
