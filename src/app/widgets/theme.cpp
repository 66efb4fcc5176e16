#include "app/widgets/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>

namespace resect {

void setTheme(bool dark) {
  QPalette palette = QStyleFactory::create("Fusion")->standardPalette();
  if (dark) {
    palette.setColor(QPalette::Window, QColor(30, 36, 40));
    palette.setColor(QPalette::WindowText, QColor(222, 228, 230));
    palette.setColor(QPalette::Base, QColor(22, 27, 30));
    palette.setColor(QPalette::AlternateBase, QColor(34, 41, 45));
    palette.setColor(QPalette::Text, QColor(222, 228, 230));
    palette.setColor(QPalette::PlaceholderText, QColor(140, 150, 154));
    palette.setColor(QPalette::Button, QColor(44, 52, 57));
    palette.setColor(QPalette::ButtonText, QColor(222, 228, 230));
    palette.setColor(QPalette::ToolTipBase, QColor(44, 52, 57));
    palette.setColor(QPalette::ToolTipText, QColor(222, 228, 230));
    palette.setColor(QPalette::Highlight, QColor(38, 128, 140));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Mid, QColor(80, 90, 95));
    palette.setColor(QPalette::Link, QColor(110, 200, 215));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
      palette.setColor(QPalette::Disabled, role, QColor(112, 120, 124));
    palette.setColor(QPalette::Disabled, QPalette::Light, QColor(22, 27, 30));
  }
  QApplication::setPalette(palette);
}

}  // namespace resect
