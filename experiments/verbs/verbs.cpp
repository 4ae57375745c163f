// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/verbs.h"

#include "experiments/verbs/voice.h"

namespace kinex::verbs {

void add_verbs(CLI::App& app, int& exit_code) {
  add_run_verb(app, exit_code);
  add_check_verb(app, exit_code);
  add_diff_verb(app, exit_code);
  add_gen_verb(app, exit_code);
  add_import_verb(app, exit_code);
  add_export_verb(app, exit_code);
  add_thin_verb(app, exit_code);
  add_roots_verb(app, exit_code);
  add_verify_verb(app, exit_code);
  add_trade_verb(app, exit_code);
  add_reproduce_verb(app, exit_code);
  add_sweep_verb(app, exit_code);
  add_view_verb(app, exit_code);
  add_ccd_verb(app, exit_code);
  add_log_verb(app, exit_code);
  add_list_verb(app, exit_code);
  add_explain_verb(app, exit_code);
  add_completion_verb(app, exit_code);
  add_help_verb(app, exit_code);
  add_voice_options(app);
}

}  // namespace kinex::verbs
