// All branches of an operation side by side.
#pragma once

#include <QDialog>
#include <functional>

#include "operation/live/timeline.h"

namespace resect {

class BranchesDialog : public QDialog {
 public:
  // wanted: called with the branch that the person wants to look at.
  BranchesDialog(const Timeline& timeline, std::int64_t present, double frameRate,
                 std::function<void(std::int64_t)> wanted, QWidget* parent);
};

}  // namespace resect
