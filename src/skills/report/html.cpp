#include "skills/report/html.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "io/data_folder.h"
#include "io/whole_file.h"

namespace resect {

std::string htmlText(std::string_view text) {
  std::string safe;
  for (const char c : shownText(text, kLongestShownPath)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string filled(const std::string& templateFile, const HtmlPlaces& places) {
  const std::string text = readWholeFile(dataFolder() / "report" / templateFile);
  std::string page;
  std::size_t at = 0;
  for (std::size_t open; (open = text.find("{{", at)) != text.npos;) {
    const std::size_t close = text.find("}}", open);
    if (close == text.npos) break;
    const std::string_view name = std::string_view(text).substr(open + 2, close - open - 2);
    const auto value =
        std::ranges::find_if(places, [&](const auto& place) { return place.first == name; });
    if (value == places.end())
      throw error("{}: has a place for \"{}\", which is not known; install Resect's data again",
                  templateFile, name);
    page.append(text, at, open - at).append(value->second);
    at = close + 2;
  }
  return page.append(text, at);
}

std::string htmlPage(std::string_view title, const std::string& body, std::string_view footer) {
  return filled("page.html", {{"title", htmlText(title)},
                              {"style", readWholeFile(dataFolder() / "report" / "style.css")},
                              {"body", body},
                              {"footer", htmlText(footer)}});
}

std::string toHtml(const HtmlTable& table) {
  std::string html = "<div class=\"scroll\"><table>\n";
  const auto row = [&](const std::vector<HtmlCell>& cells, const char* tag) {
    html += "<tr>";
    for (const HtmlCell& cell : cells)
      html += fmt::format("<{0} class=\"{1}\">{2}</{0}>", tag, cell.style, cell.html);
    html += "</tr>\n";
  };
  if (!table.head.empty()) row(table.head, "th");
  for (const auto& cells : table.rows) row(cells, "td");
  return html + "</table></div>\n";
}

std::string htmlList(const std::vector<std::string>& items) {
  std::string html = "<ul>\n";
  for (const std::string& item : items) html += "<li>" + item + "</li>\n";
  return html + "</ul>\n";
}

std::string htmlSection(std::string_view title, const std::string& content) {
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", htmlText(title), content);
}

std::string htmlFigure(const std::string& content, std::string_view caption) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", content,
                     htmlText(caption));
}

}  // namespace resect
