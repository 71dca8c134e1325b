// The texts of the command line, as one context for translators.
#pragma once

namespace mapwright::app {

class Text {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

}  // namespace mapwright::app
