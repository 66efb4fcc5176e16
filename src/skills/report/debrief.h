// The debrief is the report about an attempt: one self-contained HTML page, without script or
// network access. Its layout suits a screen, a phone and paper; a browser can print it as PDF.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "skills/class/class_book.h"
#include "skills/score/bands.h"
#include "skills/score/verdict.h"

namespace resect {

struct Debrief {
  // Attempts of one learner, the oldest first. The debrief is about the last of them.
  std::span<const Scored> attempts;
  std::span<const Scored> references;  // attempts to compare with
  // Attempts at the same task, from a history of scores. earlier: attempts that this learner made
  // before those in `attempts`, the oldest first. others: attempts of all other learners.
  std::vector<ClassAttempt> earlier = {}, others = {};
  std::vector<PublishedStudy> studies = {};
  // Per fault of the last attempt (Verdict::deductions): the bytes of a PNG file, or an empty
  // string.
  std::vector<std::string> pictures = {};
  // Bytes of an MP4 file about the first fault that has a time; may be empty.
  std::string clip = {};
};

// Throws Error if a template is missing.
std::string debriefPage(const Debrief& debrief);

// A PNG file as an <img> element; "" if `png` is empty. about: the alternative text.
std::string htmlPicture(const std::string& png, std::string_view about);

}  // namespace resect
