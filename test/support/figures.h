// Writes the figures of the validation to a table per experiment in the build folder:
// validation/NAME.csv, which tools/validation turns into docs/validation.md's tables and plots.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace resect::test {

class Figures {
 public:
  explicit Figures(const std::string& experiment) {
    std::filesystem::create_directories("validation");
    file_.open("validation/" + experiment + ".csv");
    file_ << "quantity,measured,reference,allowed\n";
  }
  // Returns the relative error, |measured / reference - 1|; `allowed` is what the test allows.
  double add(const std::string& quantity, double measured, double reference, double allowed) {
    file_ << '"' << quantity << "\"," << measured << ',' << reference << ',' << allowed << '\n';
    return std::abs(measured / reference - 1);
  }
  // A figure that is itself an error, with the most that is allowed; returned as it is.
  double addError(const std::string& quantity, double error, double allowed) {
    file_ << '"' << quantity << "\"," << error << ",," << allowed << '\n';
    return error;
  }

 private:
  std::ofstream file_;
};

}  // namespace resect::test
