#include "record/export/tables.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/text/printed_time.h"

namespace resect {
namespace {

// Foreign recordings may name a tool or an organ that is not there: then the cell is empty.
void toolCell(CsvWriter& csv, const Replay& replay, std::int64_t tool) {
  csv.cell(std::string_view(toolName(replay.setup(), tool)));
}

void organCell(CsvWriter& csv, const Replay& replay, std::int64_t organ) {
  const std::vector<ScenarioOrgan>& organs = replay.setup().scenario.organs;
  if (organ < 0 || std::size_t(organ) >= organs.size())
    csv.empty();
  else
    csv.cell(std::string_view(organs[std::size_t(organ)].source.name));
}

std::int64_t writeSamples(Replay& replay, const ExportedPart& part, CsvWriter& csv,
                          const Progress& progress) {
  csv.row("time_s", "frame", "tool", "tip_x_m", "tip_y_m", "tip_z_m", "force_x_N", "force_y_N",
          "force_z_N");
  const double frameRate = replay.setup().scenario.frameRate;
  const std::int64_t first = part.course.front().first, end = part.course.back().last;
  std::int64_t rows = 0;
  for (const CourseSpan& span : part.course) {
    std::optional<RecordedFrame> frame;  // of the sample
    for (const RecordedSample& sample : replay.file().samples(span.branch)) {
      const std::int64_t f = sample.frame;
      if (f <= span.first || f > span.last || !isDue(f, frameRate, part)) continue;
      if (!frame || frame->frame != f) {
        report(progress, double(f - first) / double(std::max<std::int64_t>(1, end - first)));
        frame = replay.file().frame(span.branch, f);
        if (!frame) continue;
      }
      csv.cell(printedTime(frame->time)).cell(f);
      toolCell(csv, replay, sample.tool);
      for (const double x : sample.tip) csv.cell(x);
      for (const double x : sample.force) csv.cell(x);
      csv.end();
      ++rows;
    }
  }
  return rows;
}

std::int64_t writeEvents(Replay& replay, const ExportedPart& part, CsvWriter& csv,
                         const Progress&) {
  csv.row("time_s", "frame", "event", "tool", "organ", "amount", "text");
  std::int64_t rows = 0;
  for (const CourseSpan& span : part.course)
    for (const OperationEvent& event : replay.file().events(span.branch)) {
      if (event.frame <= span.first || event.frame > span.last) continue;
      csv.cell(printedTime(event.time)).cell(event.frame).cell(std::string_view(event.kind));
      toolCell(csv, replay, event.tool);
      organCell(csv, replay, event.organ);
      csv.cell(event.amount).cell(std::string_view(event.text)).end();
      ++rows;
    }
  return rows;
}

// Calls visit() for the ledgers of the part, that of its first state too.
void visitLedgers(Replay& replay, const ExportedPart& part, auto visit) {
  for (const CourseSpan& span : part.course)
    for (const RecordedLedger& ledger : replay.file().ledgers(span.branch)) {
      const bool starts = &span == part.course.data() && ledger.frame == span.first;
      if (starts || (ledger.frame > span.first && ledger.frame <= span.last)) visit(ledger);
    }
}

std::int64_t writeLedger(Replay& replay, const ExportedPart& part, CsvWriter& csv,
                         const Progress&) {
  csv.row("time_s", "frame", "organ", "label", "part", "number", "particles", "ml", "g");
  std::int64_t rows = 0;
  visitLedgers(replay, part, [&](const RecordedLedger& ledger) {
    for (const RecordedLedger::Amount& a : ledger.amounts) {
      csv.cell(printedTime(ledger.time)).cell(ledger.frame);
      organCell(csv, replay, a.organ);
      csv.row(a.label, std::string_view(a.part), a.number, a.particles, a.ml, a.g);
      ++rows;
    }
  });
  return rows;
}

std::int64_t writeWounds(Replay& replay, const ExportedPart& part, CsvWriter& csv,
                         const Progress&) {
  csv.row("time_s", "frame", "organ", "label", "measure", "amount");
  std::int64_t rows = 0;
  visitLedgers(replay, part, [&](const RecordedLedger& ledger) {
    for (const RecordedLedger::Wound& wound : ledger.wounds) {
      csv.cell(printedTime(ledger.time)).cell(ledger.frame);
      organCell(csv, replay, wound.organ);
      const char* unit = wound.kind == "margin" ? "mm" : "cm2";
      csv.row(wound.label, std::string_view(wound.kind + "_" + unit), wound.amount);
      ++rows;
    }
  });
  return rows;
}

// Counts are sums over the frames since the row before.
std::int64_t writeFrames(Replay& replay, const ExportedPart& part, CsvWriter& csv,
                         const Progress& progress) {
  csv.row("time_s", "frame", "branch", "removed_particles", "removed_ml", "severed_bonds",
          "torn_bonds", "touched_particles", "faults");
  struct Sums {
    std::int64_t removed = 0, severed = 0, torn = 0, touched = 0, faults = 0;
    double ml = 0;
  } sums;
  const std::int64_t first = part.course.front().first;
  std::int64_t rows = 0;
  playMoments(
      replay, part, false,
      [&](const Simulation& now) {
        if (now.frame() == first) return;  // the state before the part's first frame
        csv.row(printedTime(now.time()), now.frame(), replay.branch(), sums.removed, sums.ml,
                sums.severed, sums.torn, sums.touched, sums.faults);
        sums = {};
        ++rows;
      },
      progress,
      [&](const StepReport& step) {
        sums.removed += step.removed;
        sums.ml += 1e6 * step.removedVolume;
        sums.severed += step.severed;
        sums.torn += step.torn;
        sums.faults += std::int64_t(step.faults.size());
        for (const ToolContacts& contacts : step.contacts)
          sums.touched += std::int64_t(contacts.cells.size());
      });
  return rows;
}

}  // namespace

std::span<const RecordingTable> recordingTables() {
  static const std::array<RecordingTable, 5> kTables{{
      {"samples", "where the tip of a tool in hand was in a frame, and the force on it", true,
       writeSamples},
      {"events", "something that happened", false, writeEvents},
      {"frames", "a frame, and what was removed, cut and torn in it", true, writeFrames},
      {"ledger", "where tissue of one label was, once a second", false, writeLedger},
      {"wounds", "an area of wounds or a margin, beside a ledger", false, writeWounds},
  }};
  return kTables;
}

std::int64_t exportTable(Replay& replay, const ExportedPart& part, const RecordingTable& table,
                         const std::filesystem::path& path, const Progress& progress) {
  std::int64_t rows = 0;
  writeCsvFile(path, [&](CsvWriter& csv) { rows = table.write(replay, part, csv, progress); });
  return rows;
}

}  // namespace resect
