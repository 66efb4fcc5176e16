// A class as an HTML page and as a CSV table.
#pragma once

#include <string>

#include "formats/export/csv_file.h"
#include "skills/class/class_book.h"

namespace resect {

// Self-contained, as a debrief (skills/report/debrief.h).
std::string classPage(const ClassBook& book, const LearningTest& test = {});

// One row per attempt.
void writeClassRows(CsvWriter& csv, const ClassBook& book, const LearningTest& test = {});

}  // namespace resect
