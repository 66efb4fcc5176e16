#include "skills/exchange/xapi.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <resect/version.h>
#include <nlohmann/json.hpp>

#include "base/state/field_hashes.h"
#include "skills/report/report_json.h"

namespace resect {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kVerbs = "http://adlnet.gov/expapi/verbs/";
constexpr const char* kExtensions = "https://resect.invalid/xapi/";

// An id of the form of a random UUID (RFC 4122, 4.4), made from a text.
std::string uuidOf(const std::string& text) {
  const std::string again = text + "\n2";
  std::uint64_t high = fastHash(text.data(), text.size());
  std::uint64_t low = fastHash(again.data(), again.size());
  high = (high & ~0xf000ull) | 0x4000ull;
  low = (low & ~(3ull << 62)) | (2ull << 62);
  return fmt::format("{:08x}-{:04x}-{:04x}-{:04x}-{:012x}", high >> 32, high >> 16 & 0xffff,
                     high & 0xffff, low >> 48, low & 0xffffffffffffull);
}

Json resultOf(const Scored& scored, bool withSuccess) {
  Json extensions;
  for (const Measured& m : scored.measures)
    if (m.instrument.empty()) extensions[kExtensions + m.measure] = printed(m.value);
  Json result{{"score",
               {{"scaled", printed(scored.verdict.score)},
                {"raw", printed(100 * scored.verdict.score)},
                {"min", 0},
                {"max", 100}}},
              {"completion", scored.verdict.goal.reached},
              {"duration", isoDuration(scored.attempt.duration())},
              {"response", scored.verdict.reason},
              {"extensions", extensions}};
  if (withSuccess) result["success"] = scored.verdict.passed;
  return result;
}

Json statement(const Scored& scored, const XapiContext& context, const std::string& verb) {
  const std::string task = scored.attempt.scenario;
  Json one{{"id", uuidOf(context.identity + "\n" + context.actor + "\n" + verb)},
           {"actor",
            {{"objectType", "Agent"},
             {"account", {{"homePage", context.home}, {"name", context.actor}}}}},
           {"verb", {{"id", kVerbs + verb}, {"display", {{"en", verb}}}}},
           {"object",
            {{"objectType", "Activity"},
             {"id", context.activities + task},
             {"definition",
              {{"type", "http://adlnet.gov/expapi/activities/simulation"},
               {"name", {{"en", scored.attempt.title}}},
               {"description", {{"en", scored.attempt.task->teaches}}}}}}}};
  if (verb != "attempted") one["result"] = resultOf(scored, verb == "passed" || verb == "failed");
  one["context"] = {{"platform", "Resect " RESECT_VERSION},
                    {"language", "en"},
                    {"extensions",
                     {{std::string(kExtensions) + "level", wordOf(scored.level)},
                      {std::string(kExtensions) + "graded", scored.verdict.graded},
                      {std::string(kExtensions) + "undos", scored.attempt.undos}}}};
  one["timestamp"] = isoTime(context.time);
  one["version"] = "1.0.3";
  return one;
}

}  // namespace

std::string isoDuration(double seconds) { return fmt::format("PT{:.2f}S", seconds); }

std::string isoTime(std::chrono::system_clock::time_point time) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch());
  const auto second = std::chrono::system_clock::to_time_t(time);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(second), ms.count() % 1000);
}

Json xapiStatements(const Scored& scored, const XapiContext& context) {
  Json all = Json::array();
  all.push_back(statement(scored, context, "attempted"));
  if (scored.verdict.goal.reached) all.push_back(statement(scored, context, "completed"));
  if (scored.verdict.graded)
    all.push_back(statement(scored, context, scored.verdict.passed ? "passed" : "failed"));
  return all;
}

}  // namespace resect
