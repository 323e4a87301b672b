// Whether anything that is drawn passes the depth test, asked without waiting: as a condition for later draws of the
// same frame, which the GPU itself obeys, and as a result that is there a frame later.
//
//     { VisibilityQuery::Scope asking(query); … draw … }
//     { VisibilityQuery::Condition unseen(query); … drawn only if some sample passed … }
//     if (const std::optional<bool> seen = query.poll()) …
#pragma once

#include "gl/object.h"

#include <optional>

namespace tarn::gl {

class VisibilityQuery {
public:
    /// Around the draws that are asked about. No two at a time.
    class Scope {
    public:
        explicit Scope(VisibilityQuery& query);
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
    };

    /// Draws and clears in its life happen only if some sample passed in the query's last scope. The GPU waits for the
    /// answer, the processor does not.
    class Condition {
    public:
        explicit Condition(const VisibilityQuery& query);
        ~Condition();
        Condition(const Condition&) = delete;
        Condition& operator=(const Condition&) = delete;
    };

    /// Whether some sample passed in the last scope; nothing before there was one, and while the answer is on its way.
    std::optional<bool> poll() const;

private:
    Object query_;
};

} // namespace tarn::gl
