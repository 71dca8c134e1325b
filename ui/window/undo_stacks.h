// Several documents with an undo stack each: Ctrl+Z is about the one that was changed last.
#pragma once

#include <QUndoGroup>
#include <QUndoStack>

namespace mapwright::window {

/// Puts the stack among those of the group, and in front whenever something of it changes. Not owned.
inline void joinUndo(QUndoGroup& group, QUndoStack& stack) {
  group.addStack(&stack);
  QObject::connect(&stack, &QUndoStack::indexChanged, &group, [&group, &stack] {
    if (stack.count() > 0) group.setActiveStack(&stack);
  });
}

}  // namespace mapwright::window
