// Several documents with an undo stack each: Ctrl+Z affects the one changed last.
#pragma once

#include <QUndoGroup>
#include <QUndoStack>

namespace mapwright::ui {

/// Adds the stack to the group, and activates it whenever it changes. Not owned.
inline void joinUndo(QUndoGroup& group, QUndoStack& stack) {
  group.addStack(&stack);
  QObject::connect(&stack, &QUndoStack::indexChanged, &group, [&group, &stack] {
    if (stack.count() > 0) group.setActiveStack(&stack);
  });
}

}  // namespace mapwright::ui
