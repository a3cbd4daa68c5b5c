# Targets of the project: what every one of them has in common is said here once.

# Settings for all targets: warnings, floating point that is the same everywhere, sanitizers.
add_library(yarte_settings INTERFACE)
target_include_directories(yarte_settings INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(yarte_settings INTERFACE cxx_std_20)
# No fused multiply-add behind our back: the same source gives the same bits on every machine.
target_compile_options(yarte_settings INTERFACE -ffp-contract=off
    $<BUILD_INTERFACE:-Wall -Wextra -Wconversion -Wshadow -Wimplicit-fallthrough>)
if(YARTE_WERROR)
    target_compile_options(yarte_settings INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
if(YARTE_HARDENING AND NOT YARTE_SANITIZE)
    # What a mistake in memory can be used for becomes less: canaries on the stack, checked copies, no jumps into the middle of
    # code, no writable tables of functions. Costs 1 % of a render's instructions. (libstdc++'s assertions would cost 4 to 6 %;
    # the sanitizers' build has them.)
    target_compile_options(yarte_settings INTERFACE
        $<BUILD_INTERFACE:-fstack-protector-strong -fstack-clash-protection>
        $<$<STREQUAL:${CMAKE_SYSTEM_PROCESSOR},x86_64>:$<BUILD_INTERFACE:-fcf-protection>>
        $<$<NOT:$<CONFIG:Debug>>:$<BUILD_INTERFACE:-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2>>) # needs optimization
    target_link_options(yarte_settings INTERFACE $<BUILD_INTERFACE:-Wl,-z,relro,-z,now,-z,noexecstack>)
endif()
if(YARTE_SANITIZE)
    target_compile_definitions(yarte_settings INTERFACE $<BUILD_INTERFACE:_GLIBCXX_ASSERTIONS>)
    # GCC's -Wmaybe-uninitialized is mistaken about instrumented library code (std::regex, for one).
    target_compile_options(yarte_settings INTERFACE
        $<BUILD_INTERFACE:-fsanitize=${YARTE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
        -Wno-maybe-uninitialized>)
    target_link_options(yarte_settings INTERFACE $<BUILD_INTERFACE:-fsanitize=${YARTE_SANITIZE}>)
endif()
install(TARGETS yarte_settings EXPORT yarte-targets)

# yarte_library(NAME SOURCES ... LINKS ... PRIVATE_LINKS ...): a static library; its headers lie beside its sources.
function(yarte_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
    add_library(${name} STATIC ${ARG_SOURCES})
    target_link_libraries(${name} PUBLIC yarte_settings ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
    install(TARGETS ${name} EXPORT yarte-targets)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
    install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder}
        FILES_MATCHING PATTERN "*.h")
endfunction()

# yarte_program(NAME SOURCES ... LINKS ...): an executable in bin/.
function(yarte_program name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE yarte_settings ${ARG_LINKS})
    install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()

# The version, for --version and reports.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/yarte/version.h CONTENT
"#pragma once
namespace yarte { inline constexpr const char* version = \"@PROJECT_VERSION@\"; }
" @ONLY)
