#include "app/window.h"

#include <QApplication>
#include <cstdlib>

#include "app/language/language.h"
#include "app/main_window.h"
#include "base/error.h"
#include "inventor/init.h"

namespace resect {

int showWindow(const WindowOptions& options) {
  const auto given = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  if (!given("DISPLAY") && !given("WAYLAND_DISPLAY") && !given("QT_QPA_PLATFORM"))
    throw error("there is no display to open a window on; use `resect run` to operate without one");
  QApplication::setStyle("Fusion");
  int count = 1;
  char name[] = "resect";
  char* arguments[] = {name, nullptr};
  QApplication application(count, arguments);
  QApplication::setOrganizationName("Resect");
  QApplication::setApplicationName("Resect");
  useLanguage(options.language);
  initInventor();
  MainWindow window(options);
  window.show();
  return QApplication::exec();
}

}  // namespace resect
