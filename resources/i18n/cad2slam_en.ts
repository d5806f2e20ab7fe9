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
    <name>cad2slam::DiagnosisMessages</name>
    <message numerus="yes">
        <source>%n anchor(s) lie beside the blueprint: %1</source>
        <translation>
            <numerusform>%n anchor lies beside the blueprint: %1</numerusform>
            <numerusform>%n anchors lie beside the blueprint: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie beside the SLAM map: %1</source>
        <translation>
            <numerusform>%n anchor lies beside the SLAM map: %1</numerusform>
            <numerusform>%n anchors lie beside the SLAM map: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie where the blueprint shows neither floor nor wall: %1</source>
        <translation>
            <numerusform>%n anchor lies where the blueprint shows neither floor nor wall: %1</numerusform>
            <numerusform>%n anchors lie where the blueprint shows neither floor nor wall: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n anchor(s) lie where the SLAM map shows neither floor nor wall: %1</source>
        <translation>
            <numerusform>%n anchor lies where the SLAM map shows neither floor nor wall: %1</numerusform>
            <numerusform>%n anchors lie where the SLAM map shows neither floor nor wall: %1</numerusform>
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
