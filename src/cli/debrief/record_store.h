// Sends statements, which say what a learner did, to a learning record store (xAPI 1.0.3) over the
// network.
//
// No other C++ code of Resect uses the network. sendStatements() is called only if the user gives a
// URL.
#pragma once

#include <string>

namespace resect {

// url: of the store's xAPI endpoint, http or https, such as "https://lrs.example.org/xapi". body: a
// JSON array of statements. credentials: "key:secret" for HTTP Basic authentication; empty: no
// authentication. Returns true if the store accepted the statements. Returns false if the store had
// them already (HTTP status 409). Throws Error if the URL is wrong, if the store cannot be reached
// within 20 s, or if the store answers with any other error.
bool sendStatements(const std::string& url, const std::string& body,
                    const std::string& credentials);

}  // namespace resect
