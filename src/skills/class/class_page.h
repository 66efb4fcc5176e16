// A class as an HTML page and as a CSV table.
#pragma once

#include <string>

#include "formats/export/csv_file.h"
#include "skills/class/class_book.h"

namespace resect {

// The HTML page. Like a debrief (skills/report/debrief.h), it needs no other file.
std::string classPage(const ClassBook& book, const LearningTest& test = {});

// One row per attempt.
void writeClassRows(CsvWriter& csv, const ClassBook& book, const LearningTest& test = {});

}  // namespace resect
