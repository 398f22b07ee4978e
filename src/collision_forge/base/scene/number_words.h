#pragma once

#include <cstddef>
#include <string>

/// Numbers in messages for people.
namespace forge {

/// Returns the number with up to six significant digits and without zeros at its end: "4.5", "20".
std::string numberText(double value);

/// Returns the number and its noun, plural unless `count` is 1: "1 vehicle", "3 vehicles". Pass
/// `plural` if the plural is not formed with an s.
std::string counted(std::size_t count, const std::string& noun, const std::string& plural = "");

/// Returns a share in [0, 1] in percent, rounded to the nearest integer: "71 %".
std::string percentText(double share);

}  // namespace forge
