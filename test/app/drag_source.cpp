// Another program from which a file is dragged: a small window, and what is pressed and moved in it
// is FILE.
//
//     drag_source FILE X Y        its window lies at (X, Y) of the screen, 100 x 60 pixels
#include <QApplication>
#include <QDrag>
#include <QFileInfo>
#include <QMimeData>
#include <QMouseEvent>
#include <QUrl>
#include <QWidget>
#include <cstdio>

namespace {

class Source : public QWidget {
 public:
  explicit Source(const QString& file) : file_(file) { setWindowTitle("drag source"); }

 protected:
  void mouseMoveEvent(QMouseEvent* event) override {
    if (!(event->buttons() & Qt::LeftButton)) return;
    auto* data = new QMimeData;
    data->setUrls({QUrl::fromUserInput(file_)});
    auto* drag = new QDrag(this);
    drag->setMimeData(data);
    const Qt::DropAction action = drag->exec(Qt::CopyAction);
    std::puts(action == Qt::CopyAction ? "taken" : "refused");
    std::fflush(stdout);
  }

 private:
  QString file_;
};

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  if (argc != 4) return 2;
  Source source(QString::fromLocal8Bit(argv[1]));
  source.setGeometry(QString(argv[2]).toInt(), QString(argv[3]).toInt(), 100, 60);
  source.show();
  return QApplication::exec();
}
