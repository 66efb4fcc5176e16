#include "app/exercise/report_pdf.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTextDocument>
#include <QUrl>

namespace resect {
namespace {

// Widths in pixels of 1/96 inch; an A4 page between the margins of QTextDocument has 642.
constexpr int kPage = 640, kThird = 208, kHalf = 330, kPhoto = 400;
constexpr int kSharpness = 3;  // pixels of a picture for each of these

// What Qt's rich text knows of CSS; the colours are those of data/report/style.css.
constexpr const char* kStyle =
    "body { font-size: 10pt; color: #1d2329; }"
    "h1 { font-size: 17pt; } h2 { font-size: 12pt; } h3 { font-size: 10pt; }"
    "th { color: #5d6873; text-align: left; } td, th { padding: 2px 6px 2px 0; }"
    ".number { text-align: right; }"
    ".quiet, .kicker, .time { color: #5d6873; font-size: 9pt; }"
    ".kept { color: #1f7a4d; } .missed { color: #b3362b; }"
    ".question { font-style: italic; }"
    ".mark, .badge { color: #ffffff; background-color: #b3362b; font-weight: bold; }"
    ".neutral { color: #ffffff; background-color: #5d6873; font-weight: bold; }"
    ".passed { color: #ffffff; background-color: #1f7a4d; font-weight: bold; }";

QImage drawn(const QString& svg, int width) {
  QSvgRenderer renderer(svg.toUtf8());
  const QSizeF size = renderer.viewBoxF().size();
  if (size.isEmpty()) return {};
  QImage image(kSharpness * width, int(kSharpness * width * size.height() / size.width()),
               QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  renderer.render(&painter);
  return image;
}

// Of a picture that turns the first of its groups.
QString still(QString svg) {
  if (!svg.contains("class=\"turn\"")) return svg;
  const qsizetype first = svg.indexOf("</g>"), last = svg.lastIndexOf("</g>");
  return svg.remove(first, last - first);
}

// Charts become images of the document, with the width that they have on paper.
QString withImages(const QString& html, QTextDocument& document) {
  static const QRegularExpression chart("<svg.*?</svg>",
                                        QRegularExpression::DotMatchesEverythingOption);
  QString out;
  qsizetype at = 0;
  int number = 0;
  for (auto all = chart.globalMatch(html); all.hasNext();) {
    const QRegularExpressionMatch match = all.next();
    out += html.mid(at, match.capturedStart() - at);
    at = match.capturedEnd();
    const QString svg = still(match.captured());
    const bool wide = svg.contains("viewBox=\"0 0 720");
    const int width = wide ? kPage : svg.contains("class=\"turn\"") ? kHalf : kThird;
    const QString name = QString("chart-%1").arg(++number);
    document.addResource(QTextDocument::ImageResource, QUrl(name), drawn(svg, width));
    out += QString("<img src=\"%1\" width=\"%2\">").arg(name).arg(width);
  }
  return out + html.mid(at);
}

// The page in the words of HTML that Qt's rich text knows.
QString asRichText(QString html) {
  html = html.mid(html.indexOf("<main>")).replace("</html>", "");
  if (html.contains("<header class=\"passed\">")) html.replace("\"badge\"", "\"passed\"");
  if (html.contains("<header class=\"\">")) html.replace("\"badge\"", "\"neutral\"");
  html.replace("; it turns, and stops under the pointer", "");
  struct Change {
    const char *from, *to;
  };
  constexpr Change kChanges[] = {
      {"<video.*?</video>", ""},
      // Figures in a row become the cells of a table.
      {"</figure>\\s*</div>", "</td></tr></table>"},
      {"<div class=\"row\">\\s*<figure>", "<table width=\"100%\"><tr><td>"},
      {"</figure>\\s*<figure>(?=\\s*<img[^>]*width=\"208\")", "</td><td>"},
      {"<figcaption>", "<br><span class=\"quiet\">"},
      {"</figcaption>", "</span>"},
      {"<figure[^>]*>", "<p>"},
      {"</figure>", "</p>"},
      {"<time>", "<span class=\"time\">"},
      {"</time>", "</span>"},
      {"<(header|section|article|main|footer)( class=\"[a-z]*\")?>", "<div>"},
      {"</(header|section|article|main|footer)>", "</div>"},
      {"<table>", "<table width=\"100%\" cellspacing=\"0\">"},
  };
  for (const Change& one : kChanges)
    html.replace(QRegularExpression(one.from, QRegularExpression::DotMatchesEverythingOption),
                 one.to);
  return html.replace("<img alt=", QString("<img width=\"%1\" alt=").arg(kPhoto));
}

}  // namespace

std::string reportPdf(const std::string& page, const std::string& title) {
  qputenv("QT_QPA_PLATFORM", "offscreen");  // fonts, and no screen
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  int count = 1;
  char name[] = "resect";
  char* arguments[] = {name, nullptr};
  const QGuiApplication application(count, arguments);
  QTextDocument document;
  document.setDefaultStyleSheet(kStyle);
  document.setHtml(asRichText(withImages(QString::fromStdString(page), document)));
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setTitle(QString::fromStdString(title));
  writer.setCreator("Resect");
  document.print(&writer);
  return bytes.toStdString();
}

}  // namespace resect
