// Pieces of HTML: escaped text, tables, and templates with placeholders.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace resect {

// The text as one printable line (base/text/shown_text.h), with the characters & < > " ' as
// entities. The result is safe anywhere in a page, also in attributes.
std::string htmlText(std::string_view text);

// Replaces the placeholders {{name}} of a template in data/report by values. places: name and value
// of each placeholder; values must be HTML. Throws Error if a placeholder has no value.
using HtmlPlaces = std::vector<std::pair<std::string_view, std::string>>;
std::string filled(const std::string& templateFile, const HtmlPlaces& places);

// A whole page, made from data/report/page.html and data/report/style.css. title, footer: plain
// text. body: HTML.
std::string htmlPage(std::string_view title, const std::string& body, std::string_view footer);

struct HtmlCell {
  std::string html;
  const char* style = "";  // CSS class of the cell: "number", "kept", "missed", or none
};
struct HtmlTable {
  std::vector<HtmlCell> head;
  std::vector<std::vector<HtmlCell>> rows;
};
// An HTML table that scrolls sideways if the page is narrow.
std::string toHtml(const HtmlTable& table);
// An element <ul>; each item is HTML.
std::string htmlList(const std::vector<std::string>& items);
// An element <section> that begins with <h2>title</h2>; title: plain text.
std::string htmlSection(std::string_view title, const std::string& content);
std::string htmlFigure(const std::string& content, std::string_view caption);

}  // namespace resect
