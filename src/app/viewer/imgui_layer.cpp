#include "app/viewer/imgui_layer.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

constexpr float fontPixels = 13.0f; // of ImGui's own font at scale 1, its natural size

/// How many framebuffer-independent units a widget's unit spans: 2 on an X screen of 192 dpi, but 1 where the
/// window system counts in points and the framebuffer alone is finer.
float widgetScale(GLFWwindow* window)
{
    float content = 1.0f, ignored = 1.0f;
    glfwGetWindowContentScale(window, &content, &ignored);
    int windowWidth = 0, windowHeight = 0, pixelWidth = 0, pixelHeight = 0;
    glfwGetWindowSize(window, &windowWidth, &windowHeight);
    glfwGetFramebufferSize(window, &pixelWidth, &pixelHeight);
    if (windowWidth > 0 && pixelWidth > 0) content *= static_cast<float>(windowWidth) / static_cast<float>(pixelWidth);
    return std::clamp(content, 0.5f, 4.0f);
}

} // namespace

ImGuiLayer::ImGuiLayer(GLFWwindow* window) : window_(window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // a viewer leaves no files behind
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    applyScale(widgetScale(window));
}

ImGuiLayer::~ImGuiLayer()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void ImGuiLayer::applyScale(float scale)
{
    if (std::abs(scale - scale_) < 0.01f) return;
    scale_ = scale;
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    ImFontConfig font;
    font.SizePixels = std::round(fontPixels * scale);
    io.Fonts->AddFontDefault(&font);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();

    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    style.WindowRounding = 4.0f;
    style.Colors[ImGuiCol_WindowBg].w = 0.85f;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

void ImGuiLayer::beginFrame()
{
    applyScale(widgetScale(window_));
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void ImGuiLayer::draw()
{
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool ImGuiLayer::wantsKeys() const { return ImGui::GetIO().WantTextInput; }

bool ImGuiLayer::wantsMouse() const { return ImGui::GetIO().WantCaptureMouse; }

} // namespace tarn
