#pragma once

#include <string>
#include <vector>

namespace bslnav {

/** The smallest of 1, 2, 5 times a power of ten that is at least `atLeast` (> 0). */
double niceStep(double atLeast);

/** The multiples of `step` in [lowest, highest], with a hair of tolerance at both ends. */
std::vector<double> ticksBetween(double lowest, double highest, double step);

/** A tick's value with as many decimals as its step needs; never "-0". */
std::string tickText(double value, double step);

}  // namespace bslnav
