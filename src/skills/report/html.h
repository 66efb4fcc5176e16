// Pieces of HTML: text that is safe to put into a page, tables, and templates with places to fill.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace resect {

// The text as one line that can be shown (base/text/shown_text.h), with & < > " ' as entities, so
// that it is text wherever it stands, in attributes too.
std::string htmlText(std::string_view text);

// Fills the places {{name}} of a template in data/report with the values, which are HTML already.
// Throws Error if the template has a place without value.
using HtmlPlaces = std::vector<std::pair<std::string_view, std::string>>;
std::string filled(const std::string& templateFile, const HtmlPlaces& places);

// A whole page: data/report/page.html with data/report/style.css. title, footer: plain text.
std::string htmlPage(std::string_view title, const std::string& body, std::string_view footer);

struct HtmlCell {
  std::string html;
  const char* style = "";  // class of the cell: "number", "kept", "missed"
};
struct HtmlTable {
  std::vector<HtmlCell> head;
  std::vector<std::vector<HtmlCell>> rows;
};
// A table that scrolls sideways where the page is narrow.
std::string toHtml(const HtmlTable& table);
// "<ul>...": each item is HTML.
std::string htmlList(const std::vector<std::string>& items);
// "<section><h2>title</h2>...": title is plain text.
std::string htmlSection(std::string_view title, const std::string& content);
std::string htmlFigure(const std::string& content, std::string_view caption);

}  // namespace resect
