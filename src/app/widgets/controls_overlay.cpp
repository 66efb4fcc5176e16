#include "app/widgets/controls_overlay.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <utility>
#include <vector>

namespace resect {
namespace {

using Controls = std::vector<std::pair<const char*, const char*>>;

const Controls kGuided = {
    {"An instrument's number", "takes it; so does a click on it, or in the list"},
    {"Move the mouse", "it hovers over the organ; the arrow is the way its edge faces"},
    {"Press and draw", "it cuts, pulls or pushes until the button is released"},
    {"Wheel, page keys", "deeper or shallower; Shift + wheel: turn its edge"},
    {"F while pressing", "leaves it at work there; take another one meanwhile"},
    {"Escape", "puts it back into the tool box"},
    {"D, B, T; S", "move it freely, by handle box, trackball; along the surface again"},
    {"P, the pencil in hand", "hold it down to press the pedal: it coagulates and does not cut"},
};

// In the thesis's mode, where instruments do not follow the surface.
const Controls kThesis = {
    {"Drag an instrument", "move it across the view"},
    {"Wheel", "move it in depth; Shift: roll it"},
    {"Shift + drag", "turn it about its tip"},
    {"An instrument's number", "takes it"},
    {"C", "hold it down to close the scissors"},
    {"Arrow keys, page keys", "move in steps; with Shift: turn"},
    {"Click an instrument", "handle box, the precise way; middle click: trackball"},
    {"Click elsewhere / Escape", "let go / back into the tool box"},
};

const Controls kAlways = {
    {"Right drag, Ctrl + wheel", "look round, zoom to the pointer; L, then a click: look there"},
    {"Ctrl + 1 2 3 4", "surgeon, assistant, top, laparoscope"},
    {"Ctrl + Z", "takes the last stroke back; with Shift does it again"},
    {"Drag in the timeline", "shows any earlier moment; End: back to the end"},
    {"Ctrl + S, Ctrl + O", "save the operation; open one and go on"},
    {"Ctrl + T", "exercises with a goal, guidance and a result"},
    {"P, Ctrl + N", "play the scenario's motions; begin again"},
    {"Space, A", "bring back view and instruments; show all there is"},
    {"F2", "the laboratory: cells, surface, timing"},
};

}  // namespace

ControlsOverlay::ControlsOverlay(QWidget* parent) : QWidget(parent) {
  setAccessibleName("Controls");
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
    keys = std::max(keys, QFontMetrics(bold).horizontalAdvance(key));
    words = std::max(words, metrics.horizontalAdvance(what));
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
  painter.drawText(28, 18 + metrics.ascent(), "Take an instrument and work on the organ");
  int y = 18 + row + 8;
  for (const auto& [key, what] : controls) {
    painter.setFont(bold);
    painter.setPen(QColor(150, 210, 220));
    painter.drawText(28, y + metrics.ascent(), key);
    painter.setFont(font());
    painter.setPen(QColor(225, 232, 235));
    painter.drawText(28 + keys + 28, y + metrics.ascent(), what);
    y += row;
  }
  painter.setPen(QColor(140, 155, 160));
  painter.drawText(28, y + 6 + metrics.ascent(), "Click to begin. F1 shows this again.");
}

}  // namespace resect
