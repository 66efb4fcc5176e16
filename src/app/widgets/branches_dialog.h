// Dialog that shows all branches of an operation side by side. A new branch begins when the user
// goes back to an earlier moment and operates from there.
#pragma once

#include <QDialog>
#include <functional>

#include "operation/live/timeline.h"

namespace resect {

class BranchesDialog : public QDialog {
 public:
  BranchesDialog(const Timeline& timeline, std::int64_t present, double frameRate, QWidget* parent);

  std::function<void(std::int64_t branch)> wanted;  // called when the user asks to see a branch
  std::function<void(std::int64_t branch, const std::string& name)> renamed;
};

}  // namespace resect
