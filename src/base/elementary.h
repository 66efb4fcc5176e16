// Elementary functions that give the same bits on every machine.
//
// The C libraries of different machines give results that differ in the last bit. The state must
// not depend on the library. So the functions here do a fixed sequence of operations. They use only
// operations on IEEE 754 doubles whose results are defined exactly (+, -, *, /, fused multiply-add,
// square root, rounding), and integer operations on the bits of doubles. The errors of the results
// are below 2 units in the last place (test/base/elementary_test.cpp). sin() and cos() give NaN for
// |x| > 1e6. acos() gives NaN for |x| > 1. Every function gives NaN for NaN. Cost: 20 to 60
// operations per call.
//
// Method: sin(), cos() and exp() reduce x to a short interval (Cody and Waite 1980). acos() and
// atan2() reduce the problem to a small angle: the difference between the result and one of three
// tabulated angles. After the reduction, a Taylor series is summed until its remainder is below a
// hundredth of a unit in the last place. cbrt() uses Halley's iteration.
#pragma once

namespace resect::math {

double sin(double x);  // x in rad
double cos(double x);
double acos(double x);             // rad, in [0, pi]
double atan2(double y, double x);  // rad, in [-pi, pi]; atan2(0, 0) is 0
// Infinite for x > 709.78. 0 for x < -708.39, where the exact result would be a denormal number.
double exp(double x);
double cbrt(double x);

}  // namespace resect::math
