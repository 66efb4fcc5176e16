// Learning curves of a learner's attempts at a task.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace resect {

// Cumulative sum of the differences from a target: S_i = S_(i-1) + (x_i - target), where x_i is the
// i-th value. The curve rises while the learner's values are above the target, and falls while they
// are below it.
std::vector<double> cusum(std::span<const double> values, double target);

// LC-CUSUM, a test whether a trainee has become competent (Biau, Williams, Schlup, Nizard and
// Porcher 2008, Br J Surg 95:925). Its curve is S_i = max(0, S_(i-1) + W_i). After a success W_i is
// ln((1 - adequate) / (1 - inadequate)), after a failure W_i is ln(adequate / inadequate).
struct LearningTest {
  double inadequate = 0.3;  // failure rate of a learner who is not competent; a setting
  double adequate = 0.1;    // failure rate of a competent learner, < `inadequate`; a setting
  double signal = 1.25;     // value of S from which on competence is shown; a setting
};
std::vector<double> learningCusum(const std::vector<bool>& passed, const LearningTest& test = {});
// Number, from 0, of the first attempt at which the curve reaches test.signal; none if it never
// does.
std::optional<std::size_t> competentAt(std::span<const double> curve,
                                       const LearningTest& test = {});

}  // namespace resect
