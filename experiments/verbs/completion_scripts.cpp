// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/completion_scripts.h"

#include <string_view>

namespace kinex::verbs {

namespace {

std::string joined(const std::vector<std::string>& words, std::string_view between = " ") {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

// Within single quotes of any of the three shells.
std::string quoted(std::string_view text, std::string_view quote) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string(quote) : std::string(1, c);
  return result + "'";
}

std::vector<std::string> option_names(const Command& command) {
  std::vector<std::string> names;
  for (const CommandOption& option : command.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::vector<std::string> verbs_of(const Command& command) {
  std::vector<std::string> names;
  for (const Command& below : command.commands) names.push_back(below.path.back());
  return names;
}

std::string head(std::string_view shell) {
  return "# kinex: completion for " + std::string(shell) + ", made by `kinex completion " +
         std::string(shell) + "`.\n";
}

// ---- bash ---------------------------------------------------------------------------------------

std::string bash_offer(const CommandValue& value) {
  const std::string offer = "_kinex_offer " + quoted(joined(value.words), "'\\''") +
                            (value.files  ? " files"
                             : value.list ? " list"
                                          : "");
  if (value.after.empty()) return offer;
  std::string text = "case \" ${COMP_WORDS[*]:1:COMP_CWORD-1} \" in";
  for (const auto& [word, words] : value.after) {
    text += " *\" " + word + " \"*) _kinex_offer " + quoted(joined(words), "'\\''") + " ;;";
  }
  return text + " *) " + offer + " ;; esac";
}

// ---- zsh ----------------------------------------------------------------------------------------

// In a specification of _arguments or _describe.
std::string zsh_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_action(const CommandValue& value) {
  if (!value.after.empty()) {
    std::string text = "{case \" $words \" in";
    for (const auto& [word, words] : value.after) {
      text += " (*\" " + word + " \"*) compadd -- " + joined(words) + " ;;";
    }
    return text + " (*) compadd -- " + joined(value.words) + " ;; esac}";
  }
  if (value.list) return "_values -s , name " + joined(value.words);
  const std::string words = "(" + zsh_text(joined(value.words)) + ")";
  if (value.words.empty()) return value.files ? "_files" : " ";
  if (!value.files) return words;
  return "{_alternative \"names:name:" + words + "\" \"files:file:_files\"}";
}

std::string zsh_function(const Command& command) {
  return "_kinex" + (command.path.empty() ? "" : "_" + joined(command.path, "_"));
}

std::string zsh_arguments(const Command& command) {
  std::string text = "  _arguments -C";
  for (const CommandOption& option : command.options) {
    for (const std::string& name : option.names) {
      std::string one = "*" + name + "[" + zsh_text(option.text) + "]";
      if (option.takes_value) one += ":value:" + zsh_action(option.value);
      text += " \\\n    " + quoted(one, "'\\''");
    }
  }
  if (!command.commands.empty()) {
    text += " \\\n    '1:verb:->verb' '*::words:->below'";
  } else if (!command.words.words.empty() || command.words.files) {
    text += " \\\n    " + quoted("*:word:" + zsh_action(command.words), "'\\''");
  }
  return text + "\n";
}

}  // namespace

std::string bash_completion(const Command& program) {
  std::string known, values, options, words;
  for (const Command* command : all_commands(program)) {
    const std::string path = joined(command->path);
    if (!path.empty()) known += (known.empty() ? "" : " | ") + quoted(path, "");
    for (const CommandOption& option : command->options) {
      if (!option.takes_value) continue;
      std::vector<std::string> cases;
      for (const std::string& name : option.names) cases.push_back(quoted(path + " " + name, ""));
      values += "    " + joined(cases, " | ") + ") " + bash_offer(option.value) + "; return ;;\n";
    }
    options +=
        "      " + quoted(path, "") + ") " + bash_offer({option_names(*command), false}) + " ;;\n";
    const CommandValue offered =
        command->commands.empty() ? command->words : CommandValue{verbs_of(*command), false};
    words += "      " + quoted(path, "") + ") " + bash_offer(offered) + " ;;\n";
  }
  return head("bash") +
         "_kinex_offer() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]}\n"
         "  [ \"$word\" != = ] || word=\n"
         "  if [ \"${2-}\" = list ]; then\n"
         "    local before=\n"
         "    [[ $word != *,* ]] || before=${word%,*},\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$1\" -P \"$before\" -- \"${word##*,}\")\n"
         "    compopt -o nospace 2>/dev/null\n"
         "    return\n"
         "  fi\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$word\")\n"
         "  if [ \"${2-}\" = files ]; then\n"
         "    local file\n"
         "    while IFS= read -r file; do COMPREPLY+=(\"$file\"); done < <(compgen -f -- "
         "\"$word\")\n"
         "    compopt -o filenames 2>/dev/null\n"
         "  fi\n"
         "}\n"
         "_kinex() {\n"
         "  local before=${COMP_WORDS[COMP_CWORD-1]} path= longer i\n"
         "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
         "    longer=${path:+$path }${COMP_WORDS[i]}\n"
         "    case $longer in\n"
         "      " +
         known +
         ") path=$longer ;;\n"
         "    esac\n"
         "  done\n"
         "  # --option=value is three words.\n"
         "  [ \"${COMP_WORDS[COMP_CWORD]}\" != = ] || before==\n"
         "  if [ \"$before\" = = ]; then\n"
         "    i=$COMP_CWORD\n"
         "    [ \"${COMP_WORDS[i]}\" = = ] || i=$((i - 1))\n"
         "    before=${COMP_WORDS[i-1]}\n"
         "  fi\n"
         "  case \"$path $before\" in\n" +
         values +
         "  esac\n"
         "  case ${COMP_WORDS[COMP_CWORD]} in\n"
         "    -*) case $path in\n" +
         options +
         "    esac ;;\n"
         "    *) case $path in\n" +
         words +
         "    esac ;;\n"
         "  esac\n"
         "}\n"
         "complete -F _kinex kinex\n";
}

std::string zsh_completion(const Command& program) {
  std::string text = "#compdef kinex\n" + head("zsh");
  for (const Command* command : all_commands(program)) {
    text += zsh_function(*command) + "() {\n";
    if (command->commands.empty()) {
      text += zsh_arguments(*command) + "}\n";
      continue;
    }
    text += "  local context state state_descr line\n  typeset -A opt_args\n";
    text += zsh_arguments(*command) +
            "  case $state in\n    verb)\n      local -a verbs\n      verbs=(\n";
    for (const Command& below : command->commands) {
      text += "        " + quoted(below.path.back() + ":" + zsh_text(below.text), "'\\''") + "\n";
    }
    text += "      )\n      _describe verb verbs ;;\n    below)\n      case $words[1] in\n";
    for (const Command& below : command->commands) {
      text += "        " + below.path.back() + ") " + zsh_function(below) + " ;;\n";
    }
    text += "      esac ;;\n  esac\n}\n";
  }
  return text +
         "if [ \"$funcstack[1]\" = _kinex ]; then\n  _kinex \"$@\"\nelse\n  compdef _kinex "
         "kinex\nfi\n";
}

std::string fish_completion(const Command& program) {
  std::string known, rules;
  for (const Command* command : all_commands(program)) {
    const std::string path = joined(command->path);
    if (!path.empty()) known += " " + quoted(path, "\\'");
    const std::string here = "complete -c kinex -n " + quoted("__kinex_at " + path, "\\'");
    for (const Command& below : command->commands) {
      rules += here + " -a " + below.path.back() + " -d " + quoted(below.text, "\\'") + "\n";
    }
    for (const CommandOption& option : command->options) {
      rules += here;
      for (const std::string& name : option.names) {
        rules += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      if (option.takes_value) {
        rules += option.value.files ? " -r -F" : " -x";
        if (!option.value.words.empty()) {
          const std::string names = joined(option.value.words);
          rules +=
              " -a " + quoted(option.value.list ? "(__kinex_list " + names + ")" : names, "\\'");
        }
      }
      rules += " -d " + quoted(option.text, "\\'") + "\n";
    }
    if (command->words.files) rules += here + " -F\n";
    std::string elsewhere;
    for (const auto& [word, words] : command->words.after) {
      rules += "complete -c kinex -n " +
               quoted("__kinex_at " + path + "; and __kinex_behind " + word, "\\'") + " -a " +
               quoted(joined(words), "\\'") + "\n";
      elsewhere += "; and not __kinex_behind " + word;
    }
    if (!command->words.words.empty()) {
      rules += "complete -c kinex -n " + quoted("__kinex_at " + path + elsewhere, "\\'") + " -a " +
               quoted(joined(command->words.words), "\\'") + "\n";
    }
  }
  return head("fish") +
         "# True if the words so far name this command, whatever options stand between them.\n"
         "function __kinex_at\n"
         "  set -l words (commandline -opc)\n"
         "  set -e words[1]\n"
         "  set -l path ''\n"
         "  for word in $words\n"
         "    set -l longer (string trim -- \"$path $word\")\n"
         "    if contains -- $longer" +
         known +
         "\n"
         "      set path $longer\n"
         "    end\n"
         "  end\n"
         "  test \"$path\" = \"$argv\"\n"
         "end\n"
         "# True if this word stands before the one to complete.\n"
         "function __kinex_behind\n"
         "  set -l words (commandline -opc)\n"
         "  contains -- $argv[1] $words[2..-1]\n"
         "end\n"
         "# The names, behind what ends with the last comma.\n"
         "function __kinex_list\n"
         "  set -l before (string match -r -- '.*,' (commandline -ct))\n"
         "  for name in $argv\n"
         "    echo \"$before$name\"\n"
         "  end\n"
         "end\n"
         "complete -c kinex -f\n" +
         rules;
}

}  // namespace kinex::verbs
