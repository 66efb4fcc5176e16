#include "cli/debrief/record_store.h"

#include <curl/curl.h>

#include <memory>

#include "base/error.h"
#include "base/text/shown_text.h"

namespace resect {
namespace {

constexpr long kSeconds = 20;
constexpr std::size_t kMostAnswer = 1 << 16;  // bytes of an answer that are kept for messages

std::size_t keep(const char* bytes, std::size_t size, std::size_t count, void* text) {
  auto& answer = *static_cast<std::string*>(text);
  answer.append(bytes, std::min(size * count, kMostAnswer - std::min(kMostAnswer, answer.size())));
  return size * count;
}

std::string endpoint(const std::string& url) {
  if (!url.starts_with("http://") && !url.starts_with("https://"))
    throw usageError(
        "--lrs is \"{}\"; give the address of a store, as https://lrs.example.org/xapi", url);
  return (url.ends_with('/') ? url.substr(0, url.size() - 1) : url) + "/statements";
}

}  // namespace

bool sendStatements(const std::string& url, const std::string& body,
                    const std::string& credentials) {
  const std::string address = endpoint(url);
  const std::unique_ptr<CURL, void (*)(CURL*)> curl(::curl_easy_init(), ::curl_easy_cleanup);
  if (!curl) throw error("the network library cannot be started; send the file of --xapi by hand");
  curl_slist* list = ::curl_slist_append(nullptr, "Content-Type: application/json");
  list = ::curl_slist_append(list, "X-Experience-API-Version: 1.0.3");
  const std::unique_ptr<curl_slist, void (*)(curl_slist*)> headers(list, ::curl_slist_free_all);
  std::string answer;
  ::curl_easy_setopt(curl.get(), CURLOPT_URL, address.c_str());
  ::curl_easy_setopt(curl.get(), CURLOPT_PROTOCOLS_STR, "http,https");
  ::curl_easy_setopt(curl.get(), CURLOPT_HTTPHEADER, headers.get());
  ::curl_easy_setopt(curl.get(), CURLOPT_POSTFIELDSIZE_LARGE, curl_off_t(body.size()));
  ::curl_easy_setopt(curl.get(), CURLOPT_POSTFIELDS, body.c_str());
  ::curl_easy_setopt(curl.get(), CURLOPT_WRITEFUNCTION, keep);
  ::curl_easy_setopt(curl.get(), CURLOPT_WRITEDATA, &answer);
  ::curl_easy_setopt(curl.get(), CURLOPT_TIMEOUT, kSeconds);
  ::curl_easy_setopt(curl.get(), CURLOPT_NOSIGNAL, 1L);
  if (!credentials.empty()) {
    ::curl_easy_setopt(curl.get(), CURLOPT_HTTPAUTH, CURLAUTH_BASIC);
    ::curl_easy_setopt(curl.get(), CURLOPT_USERPWD, credentials.c_str());
  }
  if (const CURLcode code = ::curl_easy_perform(curl.get()); code != CURLE_OK)
    throw error(
        "{}: the store cannot be reached ({}); check the address, or send the file of "
        "--xapi later",
        address, ::curl_easy_strerror(code));
  long status = 0;
  ::curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &status);
  if (status == 409) return false;
  if (status < 200 || status > 299)
    throw error("{}: the store answered {}{}; check the address and the key in RESECT_LRS_KEY",
                address, status, answer.empty() ? "" : ": " + shownText(answer));
  return true;
}

}  // namespace resect
