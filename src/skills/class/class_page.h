// A class as an HTML page and as a CSV table.
#pragma once

#include <string>

#include "formats/export/csv_file.h"
#include "skills/class/class_book.h"

namespace resect {

// The HTML page. It needs no other file. test: settings of the test whether a learner has become
// competent.
std::string classPage(const ClassBook& book, const LearningTest& test = {});

// One row per attempt.
void writeClassRows(CsvWriter& csv, const ClassBook& book, const LearningTest& test = {});

}  // namespace resect
