#include "app/widgets/branches_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/language/words.h"
#include "app/say.h"
#include "app/widgets/timeline_panel.h"

namespace resect {

BranchesDialog::BranchesDialog(const Timeline& timeline, std::int64_t present, double frameRate,
                               QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(Words::tr("Branches"));
  const QStringList titles{Words::tr("Branch"),          Words::tr("Begins at"),
                           Words::tr("Ends at"),         Words::tr("Strokes"),
                           Words::tr("Removed, ml"),     Words::tr("Pieces"),
                           Words::tr("In pieces, ml"),   Words::tr("Cut, cm\u00b2"),
                           Words::tr("Bared, cm\u00b2"), Words::tr("Largest force, N")};
  auto* table = new QTableWidget(0, int(titles.size()), this);
  table->setHorizontalHeaderLabels(titles);
  table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table->setToolTip(Words::tr("Double click a name to change it"));
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->verticalHeader()->hide();
  for (const Timeline::Course& course : timeline.courses) {
    const Branch& branch = course.branch;
    if (branch.number != 0 && branch.number != present && course.strokes.empty()) continue;
    const int row = table->rowCount();
    table->insertRow(row);
    const QStringList texts{
        shown(branch.name),
        clockText(double(branch.from) / frameRate),
        clockText(double(course.end) / frameRate),
        QString::number(timeline.strokesOn(branch.number).size()),
        QString::number(course.removedVolume * 1e6, 'f', 2),
        QString::number(course.pieces),
        QString::number(course.piecesVolume * 1e6, 'f', 2),
        QString::number(course.cut * 1e4, 'f', 1),
        QString::number(course.bared * 1e4, 'f', 1),
        course.force > 0 ? QString::number(course.force, 'f', 2) : QString("-")};
    for (int i = 0; i < texts.size(); ++i) {
      auto* item = new QTableWidgetItem(texts[i]);
      item->setTextAlignment(Qt::AlignVCenter | (i == 0 ? Qt::AlignLeft : Qt::AlignRight));
      item->setData(Qt::UserRole, qlonglong(branch.number));
      if (i > 0) item->setFlags(item->flags() & ~Qt::ItemIsEditable);
      table->setItem(row, i, item);
    }
    if (branch.number == present) table->selectRow(row);
  }
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* show =
      buttons->addButton(Words::tr("Show the end of this branch"), QDialogButtonBox::ActionRole);
  const auto choose = [this, table] {
    const QList<QTableWidgetItem*> chosen = table->selectedItems();
    if (chosen.isEmpty() || !wanted) return;
    wanted(chosen.front()->data(Qt::UserRole).toLongLong());
    accept();
  };
  connect(show, &QPushButton::clicked, this, choose);
  connect(table, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    const QString name = item->text().trimmed().left(80);
    if (item->column() == 0 && !name.isEmpty() && renamed)
      renamed(item->data(Qt::UserRole).toLongLong(), name.toStdString());
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(table);
  column->addWidget(buttons);
  resize(860, 90 + 34 * (table->rowCount() + 2));
}

}  // namespace resect
