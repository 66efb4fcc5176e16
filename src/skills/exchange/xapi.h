// Statements of the Experience API (xAPI 1.0.3) about an attempt, for a learning record store.
#pragma once

#include <chrono>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "skills/score/verdict.h"

namespace resect {

struct XapiContext {
  // The account of the learner ("actor"). actor: the account's name, a pseudonym. home: the
  // account's home page; it identifies the system to which the account belongs.
  std::string actor = "learner";
  std::string home = "https://resect.invalid/learners";
  // The IRI of a task is `activities` followed by the scenario's name.
  std::string activities = "https://resect.invalid/tasks/";
  std::chrono::system_clock::time_point time;  // end of the attempt
  // A text that is unique to this attempt, such as the digest of its recording.
  std::string identity;
};

// The statements "attempted"; "completed" if the goal was reached; and "passed" or "failed" if the
// attempt is graded. The ids of the statements depend only on identity, actor and verb, so a store
// that receives the same attempt twice keeps it only once.
nlohmann::ordered_json xapiStatements(const Scored& scored, const XapiContext& context);

// A duration in ISO 8601: "PT12.35S".
std::string isoDuration(double seconds);
// A time in ISO 8601: "2022-03-04T05:06:07.890Z".
std::string isoTime(std::chrono::system_clock::time_point time);

}  // namespace resect
