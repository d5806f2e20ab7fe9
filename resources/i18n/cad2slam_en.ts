<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en_US">
<context>
    <name>cad2slam::AnchorEditing</name>
    <message numerus="yes">
        <source>%n anchor(s) deleted</source>
        <translation>
            <numerusform>%n anchor deleted</numerusform>
            <numerusform>%n anchors deleted</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cad2slam::Exports</name>
    <message numerus="yes">
        <source>import %n anchor(s)</source>
        <translation>
            <numerusform>import %n anchor</numerusform>
            <numerusform>import %n anchors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) imported</source>
        <translation>
            <numerusform>%n anchor imported</numerusform>
            <numerusform>%n anchors imported</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> and %n more</source>
        <translation>
            <numerusform> and %n more</numerusform>
            <numerusform> and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cad2slam::MessageBar</name>
    <message numerus="yes">
        <source>%n more message(s)</source>
        <translation>
            <numerusform>%n more message</numerusform>
            <numerusform>%n more messages</numerusform>
        </translation>
    </message>
</context>
</TS>
