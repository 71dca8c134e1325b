// One or two command lines that work, for the --help of every command.
#pragma once

namespace CLI {
class App;
}

namespace mapwright::app {

/// Under the help of `program` and of each of its commands, after all of them were added.
void addExamples(CLI::App& program);

}  // namespace mapwright::app
