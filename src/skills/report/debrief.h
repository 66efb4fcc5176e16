// The debrief of an attempt as one self-contained HTML page, without script or network access. Its
// layout suits a screen, a phone and paper; a browser can print it as PDF.
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
  std::span<const Scored> attempts;    // of one learner, oldest first; the last is debriefed
  std::span<const Scored> references;  // attempts to compare with
  // Attempts at the same task from a history of scores. earlier: the learner's own attempts before
  // `attempts`, the oldest first. others: the attempts of all other learners.
  std::vector<ClassAttempt> earlier = {}, others = {};
  std::vector<PublishedStudy> studies = {};
  // Per deduction of the last attempt: a PNG file's bytes, or empty.
  std::vector<std::string> pictures = {};
  std::string clip = {};  // bytes of an MP4 file about the first deduction with a time, or empty
};

// Throws Error if a template is missing.
std::string debriefPage(const Debrief& debrief);

// A PNG file as an <img> element; "" if `png` is empty. about: the alternative text.
std::string htmlPicture(const std::string& png, std::string_view about);

}  // namespace resect
