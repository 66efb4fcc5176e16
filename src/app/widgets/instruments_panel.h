// The panel of the instruments.
#pragma once

#include <QWidget>
#include <cstdint>
#include <functional>
#include <vector>

#include "tools/tool.h"

class QToolButton;
class QVBoxLayout;

namespace resect {

// Whether a tool is left at work. TouchesNothing: it is, but has slipped off the tissue that it
// held.
enum class LeftTool { No, Works, TouchesNothing };

// One button per instrument, pressed while that instrument is in hand. A button also shows whether
// its instrument is left at work: it is not in hand, but still holds or presses tissue.
class InstrumentsPanel : public QWidget {
 public:
  explicit InstrumentsPanel(QWidget* parent = nullptr);
  void setTools(const std::vector<ToolModel>& tools);
  // held: number of the tool in hand, -1: none. left: one value per tool.
  void show(int held, const std::vector<LeftTool>& left);
  std::function<void(int tool)> chosen;  // a tool's button was clicked
 private:
  QVBoxLayout* layout_;
  std::vector<QToolButton*> buttons_;
  std::vector<QString> names_;
};

}  // namespace resect
