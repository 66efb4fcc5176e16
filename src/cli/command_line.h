// Commands and their options: a thin wrapper of CLI11, whose headers take ten seconds to compile in
// each file that includes them.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace resect {

// An option of a command, or a positional argument. An Option is a handle and may be copied. Its
// functions change the option itself, not the handle.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required() const;
  Option showDefault() const;                                   // the help shows the default value
  Option range(int least, int most) const;                      // both included
  Option range(double least, double most) const;                // both included
  Option notNegative() const;                                   // a number, 0 or more
  Option oneOf(const std::vector<std::string>& choices) const;  // the value must be one of these
  Option values(int count) const;  // takes this number of values, one after the other
  Option oneValueEach() const;     // takes one value each time the option is given
  // The option may be given without a value; its value is then `instead`. The argument after the
  // option is taken for its value if this argument is "-" or does not begin with "-".
  Option valueOr(const std::string& instead) const;
  Option needs(Option other) const;     // allowed only together with the other option
  Option excludes(Option other) const;  // not allowed together with the other option
  bool given() const;                   // valid after the command line was parsed

 private:
  CLI::Option* option_;
};

// A command, such as "run" in `resect run`. A Command is a handle and may be copied.
class Command {
 public:
  explicit Command(CLI::App* command) : command_(command) {}

  Command subcommand(const std::string& name, const std::string& help) const;
  void requireSubcommand() const;  // the user must give one of the subcommands
  // name: "--x", "-x,--long", or "NAME" for a positional argument. `value` holds the default value
  // at first, and must live as long as the command. T: std::string, float, double, int, unsigned,
  // std::int64_t, std::uint64_t, or a std::vector of std::string or double.
  template <typename T>
  Option option(const std::string& name, T& value, const std::string& help) const;
  // `given` is called with the option's values.
  Option option(const std::string& name, std::function<void(std::vector<std::string>)> given,
                const std::string& help) const;
  // name: as in option(). A "!" stands before a flag that sets `value` to false. For example,
  // "--no-x,!--x" adds the flag --no-x, which sets `value` to true, and the flag --x, which sets
  // `value` to false.
  Option flag(const std::string& name, bool& value, const std::string& help) const;
  void footer(const std::string& text) const;  // sets the text at the end of the help
  // Passes all arguments that follow on the command line to `perform`, without parsing them. This
  // includes --help.
  void passOn(std::function<void(const std::vector<std::string>&)> perform) const;
  void action(std::function<void()> perform) const;  // sets what the command does

 private:
  CLI::App* command_;
};

}  // namespace resect
