// English texts of data files and of the layers below the window, recognised and translated.
#include <doctest/doctest.h>

#include <QCoreApplication>

#include "app/language/language.h"
#include "app/language/words.h"

using namespace resect;

namespace {

std::string german(const std::string& english) {
  static int count = 1;
  static char name[] = "test_app";
  static char* arguments[] = {name, nullptr};
  static QCoreApplication application(count, arguments);
  static const bool ready = (useLanguage("de"), true);
  CHECK(ready);
  return translated(english, kLongestSentence).toStdString();
}

}  // namespace

TEST_CASE("texts of data files are translated, also by a model's name in a sentence") {
  CHECK(german("Clip applier") == "Clip-Applikator");
  CHECK(german("Hold the tissue with the hook, and leave it holding.") ==
        "Halten Sie das Gewebe (Haken) und lassen Sie das Instrument dort halten.");
}

TEST_CASE("a sentence keeps its figures, in the order of the other language") {
  CHECK(german("The bleeding was below 10 ml/min for the last 0.5 s only; 1 s are wanted.") ==
        "Die Blutung lag nur in den letzten 0.5 s unter 10 ml/min; gewünscht sind 1 s.");
  CHECK(german("2 of 4 targets were touched and held for 1 s. Target 3 was not touched.") ==
        "2 von 4 Zielpunkten wurden 1 s lang berührt und gehalten. Zielpunkt 3 wurde nicht "
        "berührt.");
}

TEST_CASE("values that are words are translated too") {
  CHECK(german("Portal branch of segment IV of 3.2 mm cut unclipped, 5.0 ml lost, closed 2.5 s "
               "later.") ==
        "Pfortaderast von Segment IV von 3.2 mm ohne Clip durchtrennt, 5.0 ml "
        "verloren, nach 2.5 s verschlossen.");
  CHECK(german("Largest force: 3.1 N, wanted at most 2 N. The largest force was 3.1 N on the "
               "Scalpel.") ==
        "Größte Kraft: 3.1 N, gewünscht höchstens 2 N. Die größte Kraft war 3.1 N (Skalpell).");
  CHECK(german("0, from the start") == "0, ab dem Beginn");
  CHECK(german("2, from 0:12.3") == "2, ab 0:12.3");
  CHECK(german("Clips placed: 5, wanted 2 to 4.") == "Gesetzte Clips: 5, gewünscht 2 bis 4.");
  CHECK(german("The goal was reached, but not as wanted: blood lost, path length.") ==
        "Das Ziel wurde erreicht, aber nicht wie gewünscht: Blutverlust, Weglänge.");
  CHECK(german("Most of the blood, 12 ml, came from the right hepatic vein of 4.0 mm that was cut "
               "at 0:12.3.") ==
        "Das meiste Blut, 12 ml, kam aus: rechte Lebervene von 4.0 mm (durchtrennt bei 0:12.3).");
  CHECK(german("Cut along the line, 90 % of it within 6 mm and nowhere farther than 8 mm from it, "
               "while the other hand holds the tissue.") ==
        "Schneiden Sie entlang der Linie, 90 % davon innerhalb von 6 mm und nirgends weiter als 8 "
        "mm von ihr, während die andere Hand das Gewebe hält.");
  CHECK(german("Go on along the line: 60 % done; missing: 20 to 28 mm and 51 to 60 mm.") ==
        "Weiter die Linie entlang: 60 % fertig; es fehlen: 20 bis 28 mm und 51 bis 60 mm.");
  CHECK(german("the disk is too slow for the recording, which ends here; the operation goes on "
               "unrecorded") ==
        "die Festplatte ist zu langsam für die Aufzeichnung, die hier "
        "endet; die Operation geht unaufgezeichnet weiter");
}

TEST_CASE("what nobody has translated stays as it is") {
  CHECK(german("My own title") == "My own title");
  CHECK(german("from left to right.toml: there is no such file; check the name") ==
        "from left to right.toml: there is no such file; check the name");
  CHECK(german("") == "");
  CHECK(german("100 %1 %2") == "100 %1 %2");
}
