// Elementary functions that give the same bits on every machine.
//
// The C libraries of different machines give results that differ in the last bit. The state must
// not depend on the library. The functions here use only +, -, *, /, fused multiply-add, square
// root and rounding of IEEE 754 doubles, and integer operations on their bits, in a fixed order.
// Their errors are below 2 units in the last place (test/base/elementary_test.cpp). sin() and cos()
// give NaN for |x| > 1e6, acos() for |x| > 1; every function gives NaN for NaN. Cost: 20 to 60
// operations per call.
//
// Method: sin(), cos() and exp() reduce x to a short interval (Cody and Waite 1980). The arc
// functions reduce their result to its difference from one of three tabulated angles. For the
// reduced number, the Taylor series is summed until its remainder is below a hundredth of a unit in
// the last place. cbrt() uses Halley's iteration.
#pragma once

namespace resect::math {

double sin(double x);  // x in rad
double cos(double x);
double acos(double x);             // rad, in [0, pi]
double atan2(double y, double x);  // rad, in [-pi, pi]; atan2(0, 0) is 0
double exp(double x);  // infinite above 709.78; 0 below -708.39, where exp(x) would be denormal
double cbrt(double x);

}  // namespace resect::math
