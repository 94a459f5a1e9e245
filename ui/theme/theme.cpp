#include "ui/theme/theme.h"

#include <QApplication>
#include <QFont>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOptionComboBox>
#include <QStyleOptionToolButton>
#include <QTabBar>

#include "ui/theme/bundled_fonts.h"
#include "ui/theme/icons.h"
#include "ui/theme/large_controls.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {

namespace {

struct Roles {
  QColor window, base, alternate, text, placeholder, button, mid, midlight, highlight, tool_tip, disabled,
      link;
};

const Roles light_roles{QColor(0xf4, 0xf5, 0xf7), Qt::white,
                        QColor(0xf7, 0xf8, 0xfa), QColor(0x22, 0x26, 0x2a),
                        QColor(0x77, 0x7d, 0x84), QColor(0xec, 0xee, 0xf1),
                        QColor(0xb8, 0xb8, 0xb8), QColor(0xe2, 0xe5, 0xe9),
                        QColor(0x2f, 0x6f, 0xb0), QColor(0xff, 0xff, 0xf2),
                        QColor(0x9a, 0xa0, 0xa6), QColor(0x1f, 0x5f, 0xa8)};
const Roles dark_roles{QColor(0x26, 0x29, 0x2d), QColor(0x1b, 0x1d, 0x20), QColor(0x22, 0x25, 0x28),
                       QColor(0xe3, 0xe6, 0xe9), QColor(0x94, 0x9a, 0xa1), QColor(0x33, 0x37, 0x3c),
                       QColor(0x55, 0x5b, 0x62), QColor(0x3d, 0x42, 0x48), QColor(0x3b, 0x7f, 0xc4),
                       QColor(0x3a, 0x3d, 0x33), QColor(0x75, 0x7b, 0x82), QColor(0x7f, 0xb8, 0xf0)};

const ThemeColours light_colours{
    .plot = Qt::white,
    .grid = QColor(0xe3, 0xe6, 0xea),
    .frame = QColor(0x8a, 0x90, 0x98),
    .text = QColor(0x33, 0x38, 0x3e),
    .muted = QColor(0x80, 0x86, 0x8d),
    .gutter = QColor(0xf1, 0xf3, 0xf5),
    .current_line = QColor(0xff, 0xec, 0xb0),
    .path = QColor(0x1a, 0x1a, 0x1a),
    .programmed = QColor(0xe6, 0x9f, 0x00),
    .across = QColor(0xcc, 0x79, 0xa7),
    .shared = QColor(0x66, 0x66, 0x66),
    .axes = {QColor(0xd5, 0x5e, 0x00), QColor(0x00, 0x9e, 0x73), QColor(0x00, 0x72, 0xb2)},
    .cursor = QColor(0xcc, 0x00, 0x7a),
    .second_cursor = QColor(0x6a, 0x3d, 0x9a),
    .error = QColor(0xb0, 0x00, 0x20),
    .warning = QColor(0x9a, 0x63, 0x00),
    .info = QColor(0x1f, 0x5f, 0xa8)};
const ThemeColours dark_colours{
    .plot = QColor(0x1b, 0x1d, 0x20),
    .grid = QColor(0x33, 0x37, 0x3c),
    .frame = QColor(0x7c, 0x83, 0x8b),
    .text = QColor(0xd5, 0xd9, 0xdd),
    .muted = QColor(0x83, 0x8a, 0x92),
    .gutter = QColor(0x22, 0x25, 0x28),
    .current_line = QColor(0x4a, 0x42, 0x20),
    .path = QColor(0xf0, 0xf0, 0xf0),
    .programmed = QColor(0xf0, 0xb4, 0x2e),
    .across = QColor(0xe8, 0xa0, 0xcc),
    .shared = QColor(0xa0, 0xa0, 0xa0),
    .axes = {QColor(0xff, 0x8a, 0x3d), QColor(0x2f, 0xc9, 0x9b), QColor(0x56, 0xb4, 0xe9)},
    .cursor = QColor(0xff, 0x5f, 0xb8),
    .second_cursor = QColor(0xc0, 0x9b, 0xf0),
    .error = QColor(0xff, 0x7b, 0x7b),
    .warning = QColor(0xf2, 0xc0, 0x5c),
    .info = QColor(0x7f, 0xb8, 0xf0)};

QPalette make_palette(const Roles& roles, const ThemeColours& colours) {
  QPalette palette;
  palette.setColor(QPalette::Window, roles.window);
  palette.setColor(QPalette::WindowText, roles.text);
  palette.setColor(QPalette::Base, roles.base);
  palette.setColor(QPalette::AlternateBase, roles.alternate);
  palette.setColor(QPalette::Text, roles.text);
  palette.setColor(QPalette::PlaceholderText, roles.placeholder);
  palette.setColor(QPalette::Button, roles.button);
  palette.setColor(QPalette::ButtonText, roles.text);
  palette.setColor(QPalette::Highlight, roles.highlight);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, roles.link);
  palette.setColor(QPalette::Mid, roles.mid);
  palette.setColor(QPalette::Midlight, roles.midlight);
  palette.setColor(QPalette::BrightText, colours.error);  // white, it cannot be read on light
  palette.setColor(QPalette::ToolTipBase, roles.tool_tip);
  palette.setColor(QPalette::ToolTipText, roles.text);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, roles.disabled);
  }
  return palette;
}

/// Fusion with dock icons in the theme's colours instead of black.
class ThemeStyle : public QProxyStyle {
 public:
  ThemeStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

  /// Fusion draws a disabled text twice, once in white, which would be the brightest in the dark theme.
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* result) const override {
    switch (hint) {
      case SH_EtchDisabledText:
        return 0;
      case SH_Slider_AbsoluteSetButtons:  // a click on the groove moves there
        return Qt::LeftButton;
      default:
        return QProxyStyle::styleHint(hint, option, widget, result);
    }
  }
  /// Tabs narrow enough for the names of four panels in every language.
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    constexpr int crowded = 4;
    constexpr int narrow = 10;  // [px] on each side of a name
    const auto* tabs = metric == PM_TabBarTabHSpace ? qobject_cast<const QTabBar*>(widget) : nullptr;
    if (tabs != nullptr && tabs->count() >= crowded) {
      return type_pixels(narrow);
    }
    const int usual = QProxyStyle::pixelMetric(metric, option, widget);
    switch (metric) {
      case PM_SmallIconSize:
      case PM_ButtonIconSize:
      case PM_ToolBarIconSize:
      case PM_ScrollBarExtent:
      case PM_IndicatorWidth:
      case PM_IndicatorHeight:
      case PM_ExclusiveIndicatorWidth:
      case PM_ExclusiveIndicatorHeight:
      case PM_SliderThickness:
      case PM_SliderControlThickness:
      case PM_SliderLength:
      case PM_MenuButtonIndicator:
      case PM_MenuBarItemSpacing:
      case PM_ButtonMargin:
      case PM_LayoutHorizontalSpacing:
      case PM_LayoutVerticalSpacing:
        return type_pixels(usual);  // scales with the font
      default:
        return usual;
    }
  }
  /// Fusion frames the check box of a row in black, which is invisible in the dark theme.
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    if (const auto arrow = large_arrow(element, *option)) {
      draw_large_arrow(*painter, option->rect, *arrow, option->palette.color(QPalette::WindowText));
      return;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_IndicatorItemViewItemCheck && theme_of(option->palette) == ThemeKind::dark) {
      painter->save();
      painter->setPen(dark_colours.muted);
      painter->setBrush(Qt::NoBrush);
      painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
      painter->restore();
    }
  }
  /// A text that is too long for its box ends in "…": Qt cuts it within a letter.
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override {
    const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    if (element != CE_ComboBoxLabel || box == nullptr || box->editable) {
      QProxyStyle::drawControl(element, option, painter, widget);
      return;
    }
    constexpr int around_text = 2;
    constexpr int after_icon = 4;
    const int icon = box->currentIcon.isNull() ? 0 : box->iconSize.width() + after_icon;
    const QRect room = proxy()->subControlRect(CC_ComboBox, box, SC_ComboBoxEditField, widget);
    QStyleOptionComboBox shown = *box;
    shown.currentText =
        box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, room.width() - icon - around_text);
    QProxyStyle::drawControl(element, &shown, painter, widget);
  }
  /// Qt squeezes the arrow of a menu into the corner below the text, where it reads as a comma.
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override {
    const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
    if (control != CC_ToolButton || button == nullptr || !has_menu_arrow(*button)) {
      QProxyStyle::drawComplexControl(control, option, painter, widget);
      draw_large_arrows(*this, control, *option, *painter, widget);
      return;
    }
    QStyleOptionToolButton frame = *button;
    frame.features &= ~QStyleOptionToolButton::HasMenu;
    frame.text.clear();
    frame.icon = QIcon();
    QProxyStyle::drawComplexControl(control, &frame, painter, widget);
    QStyleOptionToolButton label = *button;
    label.features &= ~QStyleOptionToolButton::HasMenu;
    label.rect.adjust(0, 0, -type_pixels(arrow_room), 0);
    proxy()->drawControl(CE_ToolButtonLabel, &label, painter, widget);
    QStyleOption arrow = *button;
    const int side = type_pixels(arrow_side);
    arrow.rect = QRect(button->rect.right() - type_pixels(arrow_room) - 1,
                       button->rect.center().y() - side / 2 + 1, side, side);
    proxy()->drawPrimitive(PE_IndicatorArrowDown, &arrow, painter, widget);
  }
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override {
    const QSize whole = QProxyStyle::sizeFromContents(type, option, size, widget);
    const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
    return type == CT_ToolButton && button != nullptr && has_menu_arrow(*button)
               ? whole + QSize(type_pixels(arrow_room), 0)
               : whole + QSize(room_of_large_arrows(type), 0);
  }
  QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                       const QWidget* widget) const override {
    return large_part(control, part, QProxyStyle::subControlRect(control, option, part, widget),
                      option->rect);
  }
  QIcon standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const override {
    switch (icon) {
      case SP_DockWidgetCloseButton:
      case SP_TitleBarCloseButton:
        return dock_icon(DockIcon::close);
      case SP_TitleBarNormalButton:
        return dock_icon(DockIcon::detach);
      case SP_ToolBarHorizontalExtensionButton:
        return dock_icon(DockIcon::more);
      case SP_ToolBarVerticalExtensionButton:
        return dock_icon(DockIcon::more_below);
      default:
        return QProxyStyle::standardIcon(icon, option, widget);
    }
  }

 private:
  static constexpr int arrow_side = 9;
  static constexpr int arrow_room = 11;

  /// For a button whose whole face opens a menu.
  static bool has_menu_arrow(const QStyleOptionToolButton& button) {
    return button.features.testFlag(QStyleOptionToolButton::HasMenu) &&
           !button.features.testFlag(QStyleOptionToolButton::MenuButtonPopup) && !button.text.isEmpty();
  }
};

}  // namespace

void apply_theme(ThemeKind kind) {
  add_missing_fonts();
  QApplication::setStyle(new ThemeStyle);
  QApplication::setPalette(kind == ThemeKind::dark ? make_palette(dark_roles, dark_colours)
                                                   : make_palette(light_roles, light_colours));
  QFont font = QApplication::font();
  font.setPixelSize(type_pixels(12));
  QApplication::setFont(font);
}

ThemeKind theme_of(const QPalette& palette) {
  constexpr int middle = 128;
  return palette.color(QPalette::Window).lightness() < middle ? ThemeKind::dark : ThemeKind::light;
}

const ThemeColours& theme_colours(const QPalette& palette) {
  return theme_of(palette) == ThemeKind::dark ? dark_colours : light_colours;
}

}  // namespace feedscope::ui
