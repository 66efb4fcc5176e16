// resect export: a recording for Blender, ParaView and spreadsheets.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "base/parallel.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/process/standard_streams.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "inventor/scene/operation_view.h"
#include "io/output/run_files.h"
#include "record/export/glb_export.h"
#include "record/export/tables.h"
#include "record/export/vtp_export.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

// At 10 a second, 10 s in which the surface of 3000 elastic particles changes all the time take 20
// to 30 MB as .glb; it is the rate of the pictures of run and replay, too.
constexpr double kUsualRate = 10;

enum class Kind { Glb, Vtp, Csv };

struct ExportOptions {
  std::string file, out, table;
  RecordedPart part;
  double rate = 0;  // 0: not given
  int threads = 0;
  bool overwrite = false;
};

Kind kindOf(const ExportOptions& options) {
  std::string ending = fs::path(options.out).extension().string();
  for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".glb") return Kind::Glb;
  if (ending == ".vtp") return Kind::Vtp;
  if (ending == ".csv") return Kind::Csv;
  throw usageError(
      "--output is {}; end its name in .glb for Blender, .vtp for ParaView or .csv for a "
      "spreadsheet",
      options.out);
}

const RecordingTable& tableOf(const ExportOptions& options) {
  const std::string name = options.table.empty() ? "samples" : options.table;
  std::string names;
  for (const RecordingTable& table : recordingTables()) {
    if (table.name == name) return table;
    names += (names.empty() ? "" : ", ") + table.name;
  }
  throw usageError("--table is \"{}\"; choose one of {}", name, names);
}

void checkOptions(const ExportOptions& options, Kind kind) {
  options.part.check();
  if (kind != Kind::Csv && !options.table.empty())
    throw usageError("--table chooses a table, and {} holds surfaces; give --output a .csv",
                     options.out);
  if (kind == Kind::Csv && !tableOf(options).rated && options.rate != 0)
    throw usageError("--rate thins rows, and the {} are written whole; leave it out",
                     tableOf(options).name);
  if (!std::isfinite(options.rate))
    throw usageError("--rate is not a number; give moments per second, 0.01 to 1000");
}

void checkFiles(const ExportOptions& options, Kind kind) {
  RunOutputs outputs;
  outputs.overwrite = options.overwrite;
  if (kind == Kind::Vtp) {
    const VtpSeries series = seriesOf(options.out, "--output");
    outputs.folders.push_back(series.files);
    outputs.files.push_back({"--output", series.list});
  } else {
    outputs.files.push_back({"--output", options.out});
  }
  checkOutputs(outputs, filesOfRecording(options.file));
}

std::string megabytes(std::uint64_t bytes) {
  return fmt::format("{:.1f} MB", 1e-6 * double(bytes));
}

void writeGlb(const ExportOptions& options, Replay& replay, const ExportedPart& part) {
  std::vector<OrganColours> colours;
  for (const ScenarioOrgan& organ : replay.setup().scenario.organs)
    colours.push_back({organColour(organ.source), kCutColour});
  const GlbSummary made = exportGlb(replay, part, colours, options.out, progressBar("export"));
  printLine(placeForText({options.out}), "{}: {} moments at {:g} a second, {} surfaces, {}",
            options.out, made.moments, part.rate, made.surfaces, megabytes(made.bytes));
}

void writeSeries(const ExportOptions& options, Replay& replay, const ExportedPart& part) {
  const VtpSeries series = seriesOf(options.out, "--output");
  if (options.overwrite) {
    removeNumberedFiles(series.files);
    std::error_code ec;  // a list of files that are no more
    if (fs::is_regular_file(fs::symlink_status(series.list, ec))) fs::remove(series.list, ec);
  }
  const std::int64_t files = exportVtp(replay, part, series, progressBar("export"));
  printLine(stdout, "{}: {} moments at {:g} a second, in {}0001{} and on", series.list.string(),
            files, part.rate, series.files.before, series.files.extension);
}

void writeTable(const ExportOptions& options, Replay& replay, const ExportedPart& part) {
  const RecordingTable& table = tableOf(options);
  const std::int64_t rows = exportTable(replay, part, table, options.out, progressBar("export"));
  printLine(placeForText({options.out}), "{}: {} rows of the table \"{}\"; each is {}", options.out,
            rows, table.name, table.oneRow);
}

void run(const ExportOptions& options) {
  const ThreadLimit threads(options.threads);
  const Kind kind = kindOf(options);
  checkOptions(options, kind);
  checkFiles(options, kind);
  Replay replay(options.file);
  ExportedPart part{options.part.of(replay.file(), replay.setup().scenario.frameRate),
                    options.rate};
  if (kind != Kind::Csv && part.rate == 0) part.rate = kUsualRate;
  if (kind == Kind::Glb) return writeGlb(options, replay, part);
  if (kind == Kind::Vtp) return writeSeries(options, replay, part);
  writeTable(options, replay, part);
}

std::string tableHelp() {
  std::string text = "Which table goes to a .csv";
  for (const RecordingTable& table : recordingTables())
    text += fmt::format("{} {}: a row is {}", &table == recordingTables().data() ? ":" : ";",
                        table.name, table.oneRow);
  return text + ". Without it samples";
}

}  // namespace

void addExportCommand(Command app) {
  auto options = std::make_shared<ExportOptions>();
  Command command =
      app.subcommand("export", "Write a recording for Blender, ParaView or a spreadsheet");
  addRecordingOption(command, options->file);
  command
      .option("-o,--output", options->out,
              "What to write: .glb, animated, for Blender and viewers of glTF; .vtp, a series "
              "of files and a .pvd for ParaView; .csv, a table")
      .required();
  addPartOptions(command, options->part);
  command
      .option("--rate", options->rate,
              "Moments per second of the operation; without it 10, or every frame in a .csv")
      .range(0.01, 1000.0);
  command.option("--table", options->table, tableHelp());
  addThreadsOption(command, options->threads);
  addOverwriteOption(command, options->overwrite,
                     "the numbered .vtp files of an earlier run, and their .pvd");
  command.footer(
      "Examples:\n"
      "  resect run resect-segment-elastic --record cut.resect\n"
      "  resect export cut.resect -o cut.glb\n"
      "  resect export cut.resect -o series/cut.vtp --from 2 --to 6 --rate 30\n"
      "  resect export cut.resect -o forces.csv\n"
      "  resect export cut.resect -o events.csv --table events");
  command.action([options] { run(*options); });
}

}  // namespace resect
