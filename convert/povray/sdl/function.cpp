#include "convert/povray/sdl/function.h"

#include "convert/povray/sdl/builtins.h"
#include "convert/povray/sdl/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace yarte::convert::povray::sdl {
namespace {

using Evaluate = Function::Evaluate;
using Arguments = std::span<const double>;

Evaluate number(double v) {
    return [v](Arguments) { return v; };
}

/// Compiles an expression of numbers. As other expressions, but with ^ for powers and without vectors.
struct Compiler {
    Interpreter& in;
    const std::vector<std::string>& parameters;
    std::string missing{};         ///< what cannot be computed, if anything
    int size = 0;                  ///< operands so far
    int calledDepth = 0;           ///< of the deepest function that is called
    std::uint64_t calledSteps = 0; ///< of all of them

    Evaluate logical() {
        const Interpreter::Nested nested(in);
        Evaluate left = comparison();
        while (in.peek().is('&') || in.peek().is('|')) {
            const bool both = in.next().is('&');
            left = [a = std::move(left), b = comparison(), both](Arguments v) -> double {
                return both ? a(v) != 0 && b(v) != 0 : a(v) != 0 || b(v) != 0;
            };
        }
        return left;
    }

    Evaluate comparison() {
        Evaluate left = sum();
        for (;;) {
            const Token op = in.peek();
            const char kind = op.kind == TokenKind::punctuation ? op.mark : ' ';
            if (std::string_view("<>=lgn").find(kind) == std::string_view::npos) return left;
            in.next();
            left = [a = std::move(left), b = sum(), kind](Arguments v) -> double {
                const double l = a(v), r = b(v);
                switch (kind) {
                case '<': return l < r;
                case '>': return l > r;
                case '=': return l == r;
                case 'l': return l <= r;
                case 'g': return l >= r;
                default: return l != r;
                }
            };
        }
    }

    Evaluate sum() {
        Evaluate left = product();
        while (in.peek().is('+') || in.peek().is('-')) {
            const double sign = in.next().is('+') ? 1 : -1;
            left = [a = std::move(left), b = product(), sign](Arguments v) { return a(v) + sign * b(v); };
        }
        return left;
    }

    Evaluate product() {
        Evaluate left = sign();
        while (in.peek().is('*') || in.peek().is('/')) {
            const bool times = in.next().is('*');
            left = [a = std::move(left), b = sign(), times](Arguments v) {
                const double l = a(v), r = b(v);
                return times ? l * r : l / r;
            };
        }
        return left;
    }

    Evaluate sign() {
        const Interpreter::Nested nested(in);
        if (++size > in.environment().limits.functionSize) failTooLarge();
        if (in.accept('+')) return sign();
        if (in.accept('!')) return [a = sign()](Arguments v) -> double { return a(v) == 0; };
        if (in.accept('-')) return [a = sign()](Arguments v) { return -a(v); };
        return power();
    }

    [[noreturn]] void failTooLarge() {
        const Limits& limits = in.environment().limits;
        in.fail("sdl.function",
                fmt::format(
                    "a function of more than {} operands, or {} with those that it calls, or as many levels",
                    limits.functionSize, limits.functionSteps),
                in.peekSpan());
    }

    /// With what was compiled.
    void measure(Function& function) {
        function.depth = size + calledDepth;
        function.steps = static_cast<std::uint64_t>(size) + calledSteps;
        const Limits& limits = in.environment().limits;
        if (function.depth > limits.functionSize || function.steps > limits.functionSteps) failTooLarge();
    }

    Evaluate power() {
        Evaluate base = primary();
        if (!in.accept('^')) return base;
        return [a = std::move(base), b = sign()](Arguments v) { return std::pow(a(v), b(v)); };
    }

    Evaluate primary() {
        if (in.accept('(')) {
            Evaluate inner = logical();
            in.expect(')');
            return inner;
        }
        const Token token = in.next();
        if (token.kind == TokenKind::number) return number(token.number);
        if (token.kind != TokenKind::word) {
            in.putBack(token);
            in.failExpected("a number, a parameter or a function");
        }
        if (const auto at = std::ranges::find(parameters, token.text); at != parameters.end())
            return [i = static_cast<std::size_t>(at - parameters.begin())](Arguments v) { return v[i]; };
        if (!token.symbol) return builtin(token);
        const Value* value = token.symbol->value();
        if (value && std::holds_alternative<Shared<Function>>(*value))
            return userFunction(std::get<Shared<Function>>(*value));
        in.putBack(token);
        return constantOf(in.expressionOfName());
    }

    Evaluate constantOf(const Vector& v) {
        if (v.size > 1) missing = "vectors";
        return number(v.at[0]);
    }

    std::vector<Evaluate> arguments() {
        std::vector<Evaluate> list;
        in.expect('(');
        while (!in.peek().is(')')) {
            list.push_back(logical());
            in.comma();
        }
        in.expect(')');
        return list;
    }

    Evaluate builtin(const Token& name) {
        if (const ScalarFunction* function = scalarFunction(name.text)) {
            std::vector<Evaluate> list = arguments();
            const int count = static_cast<int>(list.size());
            if (count < function->least || count > function->most)
                in.fail("sdl.arguments", fmt::format("{} does not take {} arguments", name.text, count),
                        name.span);
            return [list = std::move(list), function](Arguments v) {
                std::vector<double> values;
                for (const Evaluate& e : list) values.push_back(e(v));
                return function->call(values);
            };
        }
        if (const auto c = constant(name.text); c && c->size == 1) return number(c->at[0]);
        if (name.text == "image_width" || name.text == "image_height" || name.text == "version")
            return number(numericBuiltin(in, name)->at[0]);
        if (name.text == "sum" || name.text == "prod" || name.text == "internal") {
            missing = name.text;
            if (in.accept('(')) {
                for (int depth = 1; depth > 0;) {
                    const Token t = in.next();
                    depth += t.is('(') ? 1 : t.is(')') ? -1 : 0;
                    if (t.kind == TokenKind::end)
                        in.fail("sdl.no-brace", "this function has no end", name.span);
                }
            }
            return number(0);
        }
        in.fail("sdl.undeclared", fmt::format("'{}' is not declared", name.text), name.span);
    }

    Evaluate userFunction(Shared<Function> function) {
        // Its components, as of a pigment's function: f(x, y, z).red
        std::vector<Evaluate> list = arguments();
        if (!function->evaluate) {
            missing = function->kind;
            if (in.accept('.')) in.next();
            return number(0);
        }
        if (list.size() != function->parameters.size())
            in.fail("sdl.arguments",
                    fmt::format("the function takes {} arguments", function->parameters.size()),
                    in.peek().span);
        calledDepth = std::max(calledDepth, function->depth);
        calledSteps += function->steps;
        return [list = std::move(list), function](Arguments v) {
            std::vector<double> values;
            for (const Evaluate& e : list) values.push_back(e(v));
            return function->evaluate(values);
        };
    }
};

} // namespace

Value parseFunction(Interpreter& in) {
    const Interpreter::Nested nested(in);
    in.next();
    auto function = std::make_shared<Function>();
    // `function { ... }`, `function(a, b) { ... }`; `function 10, 10 { ... }` is an image.
    if (in.accept('(')) {
        function->parameters.clear();
        while (!in.accept(')')) {
            const Token name = in.next();
            if (name.kind != TokenKind::word)
                in.fail("sdl.unexpected", "expected a parameter's name", name.span);
            function->parameters.emplace_back(name.text);
            in.comma();
        }
    }
    while (!in.peek().is('{')) {
        if (!in.startsExpression()) in.failExpected("'{'");
        function->kind = "image";
        in.number();
        in.comma();
    }
    in.expect('{');
    for (const char* kind : {"pattern", "pigment", "spline", "transform", "internal"})
        if (function->kind.empty() && in.peek().isWord(kind)) function->kind = kind;
    if (!function->kind.empty()) {
        in.skipBlock();
        return Shared<Function>(function);
    }
    Compiler compiler{in, function->parameters};
    Evaluate compiled = compiler.logical();
    in.expect('}');
    compiler.measure(*function);
    if (compiler.missing.empty())
        function->evaluate = std::move(compiled);
    else
        function->kind = compiler.missing;
    return Shared<Function>(function);
}

Vector call(const Function& function, std::span<const double> arguments, Interpreter& in, Span where) {
    if (!function.evaluate) {
        in.report(where, "function of " + function.kind, "is not computed: zero is taken");
        // A pigment's function gives a colour, which a component may be taken of.
        return function.kind == "pigment"     ? Vector{5, {}}
               : function.kind == "transform" ? Vector{3, {}}
                                              : Vector::number(0);
    }
    if (arguments.size() != function.parameters.size())
        in.fail("sdl.arguments",
                fmt::format("the function takes {} arguments, not {}", function.parameters.size(),
                            arguments.size()),
                where);
    in.takeSteps(function.steps, where);
    return Vector::number(function.evaluate(arguments));
}

} // namespace yarte::convert::povray::sdl
