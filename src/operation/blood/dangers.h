// What endangers the patient at the end of an operation.
#pragma once

#include <string>
#include <vector>

#include "operation/blood/blood_summary.h"

namespace resect {

// Class of haemorrhage, 1 to 4 (American College of Surgeons, ATLS 2018): class 2 begins above a
// loss of 15 % of all blood, class 3 above 30 %, class 4 above 40 %. lost: m^3.
int haemorrhageClass(double lost);

// Sentences for people, the worst first; none if nothing endangers the patient:
// - bleeding of grade 4 on the VIBe scale, that is more than 50 ml/min at the end;
// - a loss of more than 15 % of the blood: haemorrhage of class 2 to 4;
// - more than 50 ml of air in the heart; 200 to 300 ml kill (Mirski et al. 2007).
std::vector<std::string> dangersOf(const BloodSummary& blood);

}  // namespace resect
