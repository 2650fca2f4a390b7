// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/program_texts.h"

#include "commands/blends/strategy_names.h"
#include "commands/command_line.h"

#include <map>
#include <ostream>
#include <sstream>

namespace {

// A text of troff in which nothing is a command, and no hyphen is broken or turned into a dash.
std::string troff(const std::string& text) {
  std::string result;
  bool starts_line = true;
  for (const char c : text) {
    if (starts_line && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
    starts_line = c == '\n';
  }
  return result;
}

void write_block(std::ostream& os, const std::string& text) { os << ".nf\n" << troff(text) << ".fi\n"; }

std::string joined(const Arguments& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

} // namespace

std::map<std::string, Arguments> option_words() {
  Arguments strategies = quintic_names();
  strategies.push_back("fairest"); // of surfaces
  for (const std::string& name : septic_names()) strategies.push_back(name);
  strategies.insert(strategies.end(), {"free", "all"});
  return {{"strategy", strategies},
          {"kernel", {"exact", "double"}},
          {"corners", {"all", "not-g1"}},
          {"parameters", {"uniform", "chordal", "centripetal"}},
          {"format", {"text", "json", "sarif", "junit", "off", "ply", "obj", "stl"}},
          {"require", {"G1", "G2", "G3", "C1", "C2", "C3", "F3"}},
          {"to", {"G1", "G2"}},
          {"within", {"class-a", "class-b", "class-c", "vda-4955", "mil-std-31000a"}}};
}

void write_manual_page(std::ostream& os, const std::string& usage, const std::vector<const Command*>& commands) {
  os << ".TH GEOMETRIC_CONTINUITY 1 \"\" \"geometric_continuity " << GEOMETRIC_CONTINUITY_VERSION << "\"\n"
     << ".SH NAME\ngeometric_continuity \\- curves and surfaces that join smoothly, and a proof that they do\n"
     << ".SH SYNOPSIS\n.B geometric_continuity\n.I COMMAND\n[\\fIARGUMENTS\\fR]\n.SH DESCRIPTION\n";
  write_block(os, usage);
  for (const Command* command : commands) {
    std::string name = command->name;
    for (char& c : name)
      if ('a' <= c && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    os << ".SH COMMAND " << troff(name) << '\n';
    write_block(os, command->usage);
    const po::options_description options = Command_line::options_of(*command);
    for (const auto& option : options.options()) {
      os << ".TP\n.B \\-\\-" << troff(option->long_name());
      const std::string names = option->format_name(); // "-o [ --output ]" or "--output"
      if (names.compare(0, 2, "--") != 0) os << ", " << troff(names.substr(0, 2));
      if (option->semantic()->max_tokens() != 0) os << " \\fI" << troff(option->format_parameter()) << "\\fR";
      os << '\n' << troff(option->description()) << '\n';
    }
  }
}

void write_bash_completion(std::ostream& os, const std::vector<const Command*>& commands) {
  Arguments names;
  for (const Command* command : commands) names.push_back(command->name);
  os << "# bash completion of geometric_continuity, made of the descriptions of its commands\n"
        "_geometric_continuity() {\n"
        "  local word=${COMP_WORDS[COMP_CWORD]} words=\n"
        "  COMPREPLY=()\n"
        "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "    COMPREPLY=($(compgen -W '"
     << joined(names)
     << " --help --version' -- \"$word\"))\n"
        "    return\n"
        "  fi\n"
        "  case ${COMP_WORDS[COMP_CWORD-1]} in\n";
  for (const auto& [option, words] : option_words()) os << "  --" << option << ") words='" << joined(words) << "' ;;\n";
  os << "  *)\n"
        "    case $word in\n"
        "    -*)\n"
        "      case ${COMP_WORDS[1]} in\n";
  for (const Command* command : commands)
    os << "      " << command->name << ") words='"
       << joined(Command_line::option_names(Command_line::options_of(*command))) << "' ;;\n";
  os << "      esac\n"
        "      ;;\n"
        "    esac\n"
        "    ;;\n"
        "  esac\n"
        "  if [ -n \"$words\" ]; then\n"
        "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
        "  else\n"
        "    COMPREPLY=($(compgen -f -- \"$word\"))\n"
        "  fi\n"
        "}\n"
        "complete -o filenames -F _geometric_continuity geometric_continuity\n";
}
