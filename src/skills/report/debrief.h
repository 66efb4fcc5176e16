// The debrief of an attempt as one HTML page that needs nothing else: no script, no network. It
// fits a screen, a phone and paper; a browser prints it as PDF.
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
  std::span<const Scored> attempts;    // of one learner, the oldest first; it is about the last one
  std::span<const Scored> references;  // to compare with
  // From a history of scores, at the same task: of the learner before these attempts, the oldest
  // first; and of all other learners.
  std::vector<ClassAttempt> earlier = {}, others = {};
  std::vector<PublishedStudy> studies = {};
  // Per deduction of the last attempt: a PNG file's bytes, or empty.
  std::vector<std::string> pictures = {};
  std::string clip = {};  // bytes of an MP4 file of the first of these that has a time; or empty
};

// Throws Error if a template is missing.
std::string debriefPage(const Debrief& debrief);

// A PNG file as <img>, or nothing if there are no bytes.
std::string htmlPicture(const std::string& png, std::string_view about);

}  // namespace resect
