#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdint>

namespace resect {

Option Option::required() const {
  option_->required();
  return *this;
}

Option Option::showDefault() const {
  option_->capture_default_str();
  return *this;
}

Option Option::range(int least, int most) const {
  option_->check(CLI::Range(least, most));
  return *this;
}

Option Option::range(double least, double most) const {
  option_->check(CLI::Range(least, most));
  return *this;
}

Option Option::notNegative() const {
  option_->check([](const std::string& value) {
    return std::string(value.starts_with('-') ? value + " is negative; give 0 or more" : "");
  });
  return *this;
}

Option Option::oneOf(const std::vector<std::string>& choices) const {
  option_->check(CLI::IsMember(choices));
  return *this;
}

Option Option::values(int count) const {
  option_->expected(count);
  return *this;
}

Option Option::oneValueEach() const {
  option_->allow_extra_args(false);
  return *this;
}

Option Option::valueOr(const std::string& instead) const {
  option_->expected(0, 1)->default_str(instead);
  return *this;
}

Option Option::needs(Option other) const {
  option_->needs(other.option_);
  return *this;
}

Option Option::excludes(Option other) const {
  option_->excludes(other.option_);
  return *this;
}

bool Option::given() const { return option_->count() > 0; }

Command Command::subcommand(const std::string& name, const std::string& help) const {
  return Command(command_->add_subcommand(name, help));
}

void Command::requireSubcommand() const { command_->require_subcommand(1); }

template <typename T>
Option Command::option(const std::string& name, T& value, const std::string& help) const {
  return Option(command_->add_option(name, value, help));
}

template Option Command::option(const std::string&, std::string&, const std::string&) const;
template Option Command::option(const std::string&, float&, const std::string&) const;
template Option Command::option(const std::string&, double&, const std::string&) const;
template Option Command::option(const std::string&, int&, const std::string&) const;
template Option Command::option(const std::string&, unsigned&, const std::string&) const;
template Option Command::option(const std::string&, std::int64_t&, const std::string&) const;
template Option Command::option(const std::string&, std::uint64_t&, const std::string&) const;
template Option Command::option(const std::string&, std::vector<std::string>&,
                                const std::string&) const;
template Option Command::option(const std::string&, std::vector<double>&, const std::string&) const;

Option Command::option(const std::string& name, std::function<void(std::vector<std::string>)> given,
                       const std::string& help) const {
  return Option(command_->add_option_function<std::vector<std::string>>(name, given, help));
}

Option Command::flag(const std::string& name, bool& value, const std::string& help) const {
  return Option(command_->add_flag(name, value, help));
}

void Command::footer(const std::string& text) const { command_->footer(text); }

void Command::passOn(std::function<void(const std::vector<std::string>&)> perform) const {
  command_->set_help_flag();
  command_->prefix_command();
  command_->callback([command = command_, perform] { perform(command->remaining()); });
}

void Command::action(std::function<void()> perform) const {
  command_->callback(std::move(perform));
}

}  // namespace resect
