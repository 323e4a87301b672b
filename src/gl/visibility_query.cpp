#include "gl/visibility_query.h"

#include "gl/api.h"
#include "gl/counters.h"

namespace tarn::gl {

VisibilityQuery::Scope::Scope(VisibilityQuery& query)
{
    const bool isNew = !query.query_;
    if (isNew) query.query_ = Object(Object::Kind::query, "visibility");
    glBeginQuery(GL_SAMPLES_PASSED, query.query_.name());
    if (isNew) query.query_.announceLabel();
}

VisibilityQuery::Scope::~Scope() { glEndQuery(GL_SAMPLES_PASSED); }

VisibilityQuery::Condition::Condition(const VisibilityQuery& query)
{
    glBeginConditionalRender(query.query_.name(), GL_QUERY_WAIT);
}

VisibilityQuery::Condition::~Condition() { glEndConditionalRender(); }

std::optional<bool> VisibilityQuery::poll() const
{
    if (!query_) return std::nullopt;
    GLint available = GL_FALSE;
    count(Call::queryResult);
    glGetQueryObjectiv(query_.name(), GL_QUERY_RESULT_AVAILABLE, &available);
    if (available != GL_TRUE) return std::nullopt;
    GLuint samples = 0;
    count(Call::queryResult);
    glGetQueryObjectuiv(query_.name(), GL_QUERY_RESULT, &samples);
    return samples > 0;
}

} // namespace tarn::gl
