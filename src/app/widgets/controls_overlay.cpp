#include "app/widgets/controls_overlay.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <utility>
#include <vector>

#include "app/language/words.h"

namespace resect {
namespace {

using Controls = std::vector<std::pair<const char*, const char*>>;  // before translation

const Controls kGuided = {
    {QT_TRANSLATE_NOOP("window", "An instrument's number"),
     QT_TRANSLATE_NOOP("window", "takes it; so does a click on it, or in the list")},
    {QT_TRANSLATE_NOOP("window", "Move the mouse"),
     QT_TRANSLATE_NOOP("window", "it hovers over the organ; the arrow is the way its edge faces")},
    {QT_TRANSLATE_NOOP("window", "Press and draw"),
     QT_TRANSLATE_NOOP("window", "it cuts, pulls or pushes until the button is released")},
    {QT_TRANSLATE_NOOP("window", "Wheel, page keys"),
     QT_TRANSLATE_NOOP("window", "deeper or shallower; Shift + wheel: turn its edge")},
    {QT_TRANSLATE_NOOP("window", "F while pressing"),
     QT_TRANSLATE_NOOP("window", "leaves it at work there; take another one meanwhile")},
    {QT_TRANSLATE_NOOP("window", "Escape"),
     QT_TRANSLATE_NOOP("window", "puts it back into the tool box")},
    {QT_TRANSLATE_NOOP("window", "D, B, T; S"),
     QT_TRANSLATE_NOOP("window",
                       "move it freely, by handle box, trackball; along the surface again")},
    {QT_TRANSLATE_NOOP("window", "P, the pencil in hand"),
     QT_TRANSLATE_NOOP("window",
                       "hold it down to press the pedal: it coagulates and does not cut")},
};

// In the thesis's mode, where instruments do not follow the surface.
const Controls kThesis = {
    {QT_TRANSLATE_NOOP("window", "Drag an instrument"),
     QT_TRANSLATE_NOOP("window", "move it across the view")},
    {QT_TRANSLATE_NOOP("window", "Wheel"),
     QT_TRANSLATE_NOOP("window", "move it in depth; Shift: roll it")},
    {QT_TRANSLATE_NOOP("window", "Shift + drag"),
     QT_TRANSLATE_NOOP("window", "turn it about its tip")},
    {QT_TRANSLATE_NOOP("window", "An instrument's number"),
     QT_TRANSLATE_NOOP("window", "takes it")},
    {QT_TRANSLATE_NOOP("window", "C"),
     QT_TRANSLATE_NOOP("window", "hold it down to close the scissors")},
    {QT_TRANSLATE_NOOP("window", "Arrow keys, page keys"),
     QT_TRANSLATE_NOOP("window", "move in steps; with Shift: turn")},
    {QT_TRANSLATE_NOOP("window", "Click an instrument"),
     QT_TRANSLATE_NOOP("window", "handle box, the precise way; middle click: trackball")},
    {QT_TRANSLATE_NOOP("window", "Click elsewhere / Escape"),
     QT_TRANSLATE_NOOP("window", "let go / back into the tool box")},
};

const Controls kAlways = {
    {QT_TRANSLATE_NOOP("window", "Right drag, Ctrl + wheel"),
     QT_TRANSLATE_NOOP("window", "look round, zoom to the pointer; L, then a click: look there")},
    {QT_TRANSLATE_NOOP("window", "Ctrl + 1 2 3 4"),
     QT_TRANSLATE_NOOP("window", "surgeon, assistant, top, laparoscope")},
    {QT_TRANSLATE_NOOP("window", "Ctrl + Z"),
     QT_TRANSLATE_NOOP("window", "takes the last stroke back; with Shift does it again")},
    {QT_TRANSLATE_NOOP("window", "Drag in the timeline"),
     QT_TRANSLATE_NOOP("window", "shows any earlier moment; End: back to the end")},
    {QT_TRANSLATE_NOOP("window", "Ctrl + S, Ctrl + O"),
     QT_TRANSLATE_NOOP("window", "save the operation; open one and go on")},
    {QT_TRANSLATE_NOOP("window", "Ctrl + T"),
     QT_TRANSLATE_NOOP("window", "exercises with a goal, guidance and a result")},
    {QT_TRANSLATE_NOOP("window", "P, Ctrl + N"),
     QT_TRANSLATE_NOOP("window", "play the scenario's motions; begin again")},
    {QT_TRANSLATE_NOOP("window", "Space, A"),
     QT_TRANSLATE_NOOP("window", "bring back view and instruments; show all there is")},
    {QT_TRANSLATE_NOOP("window", "F2"),
     QT_TRANSLATE_NOOP("window", "the laboratory: cells, surface, timing")},
};

}  // namespace

ControlsOverlay::ControlsOverlay(QWidget* parent) : QWidget(parent) {
  setAccessibleName(Words::tr("Controls"));
  hide();
}

void ControlsOverlay::mousePressEvent(QMouseEvent* event) {
  hide();
  event->accept();
}

void ControlsOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), QColor(8, 16, 20, 120));
  const QFontMetrics metrics(font());
  Controls controls = guided ? kGuided : kThesis;
  controls.insert(controls.end(), kAlways.begin(), kAlways.end());
  const int row = metrics.height() + 8, rows = int(controls.size());
  QFont bold = font();
  bold.setBold(true);
  int keys = 0, words = 0;
  for (const auto& [key, what] : controls) {
    keys = std::max(keys, QFontMetrics(bold).horizontalAdvance(Words::tr(key)));
    words = std::max(words, metrics.horizontalAdvance(Words::tr(what)));
  }
  const QRect box(0, 0, keys + words + 84, row * (rows + 2) + 36);
  // Scaled down in a small window, never cut off.
  const double scale =
      std::min({1.0, (width() - 8.0) / box.width(), (height() - 8.0) / box.height()});
  painter.translate((width() - scale * box.width()) / 2, (height() - scale * box.height()) / 2);
  painter.scale(scale, scale);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(14, 26, 32, 225));
  painter.drawRoundedRect(box, 12, 12);
  painter.setFont(bold);
  painter.setPen(QColor(235, 245, 248));
  painter.drawText(28, 18 + metrics.ascent(),
                   Words::tr("Take an instrument and work on the organ"));
  int y = 18 + row + 8;
  for (const auto& [key, what] : controls) {
    painter.setFont(bold);
    painter.setPen(QColor(150, 210, 220));
    painter.drawText(28, y + metrics.ascent(), Words::tr(key));
    painter.setFont(font());
    painter.setPen(QColor(225, 232, 235));
    painter.drawText(28 + keys + 28, y + metrics.ascent(), Words::tr(what));
    y += row;
  }
  painter.setPen(QColor(140, 155, 160));
  painter.drawText(28, y + 6 + metrics.ascent(), Words::tr("Click to begin. F1 shows this again."));
}

}  // namespace resect
