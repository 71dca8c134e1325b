# Run while building: writes the commit of the sources into a source file (OUT), which stays as it is where the commit
# does. Empty without Git.
execute_process(COMMAND git rev-parse HEAD WORKING_DIRECTORY ${SOURCES}
  OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
file(WRITE ${OUT}.new "#include \"ui/window/made_of.h\"

namespace mapwright::ui {

QString builtCommit() { return QStringLiteral(\"${commit}\"); }

}  // namespace mapwright::ui
")
file(COPY_FILE ${OUT}.new ${OUT} ONLY_IF_DIFFERENT)
