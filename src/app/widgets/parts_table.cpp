#include "app/widgets/parts_table.h"

#include <QComboBox>
#include <QHeaderView>
#include <algorithm>

#include "app/language/words.h"
#include "formats/labels/brought_organ.h"
#include "io/model.h"

namespace resect {
namespace {

constexpr int kLeftOut = -1, kOrgan = 0;

int proposed(const FilePart& part) {
  const auto kind = part.kind;
  if (!kind || *kind == StructureKind::Gallbladder) return kLeftOut;  // which lies beside a liver
  return *kind == StructureKind::Parenchyma ? kOrgan : 1 + int(*kind);
}

}  // namespace

PartsTable::PartsTable(QWidget* parent) : QTableWidget(parent) {
  setColumnCount(3);
  setHorizontalHeaderLabels({Words::tr("Part"), Words::tr("Size"), Words::tr("What it is")});
  verticalHeader()->hide();
  setEditTriggers(NoEditTriggers);
  setSelectionMode(NoSelection);
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  setToolTip(Words::tr(
      "Vessels bleed when they are cut; tumours and cysts are tissue of their own; a cavity holds "
      "no tissue"));
}

void PartsTable::fill(const std::vector<FilePart>& parts, bool image) {
  parts_ = parts;
  const bool told =
      std::ranges::any_of(parts, [](const FilePart& part) { return proposed(part) == kOrgan; });
  // The parts of a model whose names tell nothing are the organ then.
  const bool others =
      std::ranges::any_of(parts, [](const FilePart& part) { return proposed(part) == kLeftOut; });
  const auto roleFor = [&](const FilePart& part) {
    const int role = proposed(part);
    if (told || image) return told ? role : kLeftOut;
    return others && role != kLeftOut ? role : kOrgan;
  };
  setRowCount(int(parts.size()));
  for (int row = 0; row < int(parts.size()); ++row) {
    const FilePart& part = parts[std::size_t(row)];
    setItem(row, 0, new QTableWidgetItem(translated(part.name)));
    setItem(row, 1, new QTableWidgetItem(translated(part.about)));
    auto* role = new QComboBox;
    role->addItem(Words::tr("left out"), kLeftOut);
    role->addItem(Words::tr("the organ's surface"), kOrgan);
    for (int k = int(StructureKind::Tumour); k < kStructureKinds; ++k) {
      std::string word(wordOf(StructureKind(k)));
      std::ranges::replace(word, '-', ' ');
      role->addItem(translated(word), 1 + k);
    }
    role->setCurrentIndex(std::max(0, role->findData(roleFor(part))));
    connect(role, &QComboBox::activated, this, [this] {
      if (changed) changed();
    });
    setCellWidget(row, 2, role);
  }
  constexpr int kMostRows = 5;  // to be seen at once
  setFixedHeight(horizontalHeader()->sizeHint().height() + 2 +
                 std::min(rowCount(), kMostRows) * rowHeight(0));
}

int PartsTable::roleOf(int row) const {
  return static_cast<const QComboBox*>(cellWidget(row, 2))->currentData().toInt();
}

bool PartsTable::hasOrgan() const {
  int organs = 0;
  for (int row = 0; row < rowCount(); ++row) organs += roleOf(row) == kOrgan;
  return ofFolder() ? organs == 1 : organs > 0;
}

const FilePart& PartsTable::organ() const {
  int row = 0;
  while (roleOf(row) != kOrgan) ++row;
  return parts_[std::size_t(row)];
}

bool PartsTable::isCavity(int row) const { return roleOf(row) == 1 + int(StructureKind::Cavity); }

QPoint PartsTable::rolePlace(int row) const {
  const QWidget* role = cellWidget(row, 2);
  return role->mapToGlobal(role->rect().center());
}

void PartsTable::applyTo(OrganSource& source) const {
  std::vector<std::string> organ;
  for (int row = 0; row < rowCount(); ++row)
    if (roleOf(row) == kOrgan) organ.push_back(parts_[std::size_t(row)].part);
  const bool all = int(organ.size()) == rowCount() && !isLabelled(source.file);
  source.part = all ? "" : partLines(organ);
  if (ofFolder() && hasOrgan()) source.file = this->organ().file, source.part = "";
  for (int row = 0; row < rowCount(); ++row) {
    if (roleOf(row) <= kOrgan) continue;
    const FilePart& part = parts_[std::size_t(row)];
    const auto kind = StructureKind(roleOf(row) - 1);
    addStructure(source, kind, part.kind ? part.name : std::string(wordOf(kind)), part.file,
                 ofFolder() ? "" : part.part);
  }
}

}  // namespace resect
